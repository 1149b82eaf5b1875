// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <fstream>

#include "tests/robot/output/temporary_folder.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

using testing::HasSubstr;

TEST(TraceProcess, SaysThatThePlanIsNotThere) {
  TemporaryFolder folder;
  const Outcome gone = twin("trace '" + (folder / "gone.png").string() + "'");
  EXPECT_EQ(gone.code, 66);
  EXPECT_THAT(gone.err, HasSubstr("gone.png: error: no such file"));
}

TEST(TraceProcess, SaysThatThePlanIsNoPicture) {
  TemporaryFolder folder;
  std::ofstream(folder / "notes.png") << "no picture";
  EXPECT_EQ(twin("trace '" + (folder / "notes.png").string() + "'").code, 65);
  std::ofstream(folder / "map.yaml") << "image: gone.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n"
                                        "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
  EXPECT_EQ(twin("trace '" + (folder / "map.yaml").string() + "'").code, 66);
  std::ofstream(folder / "bad.yaml") << "places: [1, 2]\n";
  EXPECT_EQ(twin("trace '" + (folder / "bad.yaml").string() + "'").code, 65);
  std::ofstream(folder / "bad.trace.json") << "{ \"tracing\": 2 }";
  EXPECT_EQ(twin("trace '" + (folder / "bad.trace.json").string() + "'").code, 65);
}

TEST(TraceProcess, RefusesAFolderThatIsAFileAndAnAddressThatIsNone) {
  TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  EXPECT_EQ(twin("trace --out '" + (folder / "file").string() + "'").code, 73);
  EXPECT_EQ(twin("trace --listen nonsense:port --out '" + folder.path().string() + "'").code, 2);
  EXPECT_EQ(twin("trace --out '" + (folder / ".hidden.yaml").string() + "'").code, 2);
  EXPECT_EQ(twin("trace --listen 192.0.2.1:0 --out '" + folder.path().string() + "'").code, 69);
}

TEST(TraceProcess, LeavesNothingBehindWhenItIsEnded) {
  TemporaryFolder folder;
  TemporaryFolder temporary;
  const std::string address = (folder / "address").string();
  const std::string script = (folder / "script").string();
  std::ofstream(script) << "'" << TWIN_PROGRAM << "' trace --out '" << (folder / "maps").string() << "' >'"
                        << address
                        << "' 2>/dev/null & server=$!\n"
                           "until test -s '"
                        << address << "'; do sleep 0.05; done\nkill -TERM $server\nwait $server\n";
  const std::string line = "TMPDIR='" + temporary.path().string() + "' timeout 20 sh '" + script + "'";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 143);  // NOLINT(cert-env33-c): a shell is what users have
  EXPECT_THAT(content_of(address), testing::StartsWith("http://127.0.0.1:"));
  EXPECT_TRUE(std::filesystem::is_empty(temporary.path()));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "maps"));
}

}  // namespace
}  // namespace sensotwin::twin

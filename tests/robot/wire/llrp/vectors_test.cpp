// SPDX-License-Identifier: MIT
// Messages that real readers and real clients sent, and requests made wrong on purpose (recorded beside the
// repository, ../shared/vectors).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "robot/wire/llrp/codec.hpp"

namespace sensotwin::robot::llrp {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::SizeIs;

const fs::path kVectors = fs::path{SENSOTWIN_SOURCE_DIR} / "../shared/vectors";

[[nodiscard]] Bytes bytes_of(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  return Bytes(std::istreambuf_iterator<char>{file}, {});
}

[[nodiscard]] std::vector<fs::path> files(const std::string& folder, const std::string& extension) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator{kVectors / folder}) {
    if (entry.path().extension() == extension) {
      out.push_back(entry.path());
    }
  }
  std::ranges::sort(out);
  return out;
}

/// The one message in `bytes`, which have to be exactly that.
[[nodiscard]] Result<Message, DecodeError> decode_all(const Bytes& bytes, FrameHeader& header) {
  FrameDecoder decoder;
  std::ranges::copy(bytes, decoder.room().begin());
  decoder.received(bytes.size());
  const auto frame = decoder.next();
  EXPECT_TRUE(frame && *frame);
  EXPECT_EQ((*frame)->body.size() + kHeaderBytes, bytes.size());
  header = (*frame)->header;
  return decode(**frame);
}

void expect_same_bytes_again(const fs::path& path, const Bytes& bytes) {
  FrameHeader header;
  const auto message = decode_all(bytes, header);
  ASSERT_TRUE(message) << path.filename() << ": " << name_of(message.error().fault) << " in "
                       << (message.error().path_size > 0 ? message.error().path[message.error().path_size - 1]
                                                         : 0);
  EXPECT_EQ(encode(*message, header.id), bytes) << path.filename();
}

/// Types that the names of edgex's files begin with (its README.txt).
[[nodiscard]] Bytes with_header(const fs::path& path) {
  static const std::map<std::string, std::uint16_t> kTypes{
      {"CloseConnectionResponse", 4}, {"GetReaderCapabilitiesResponse", 11}, {"GetReaderConfigResponse", 12},
      {"GetROSpecsResponse", 36},     {"GetAccessSpecsResponse", 54},        {"ROAccessReport", 61},
      {"ReaderEventNotification", 63}};
  const std::string name = path.stem().string();
  const Bytes body = bytes_of(path);
  const std::uint16_t type = kTypes.at(name.substr(0, name.find('-')));
  const std::size_t length = body.size() + kHeaderBytes;
  Bytes out(length);
  out[0] = static_cast<std::uint8_t>(0x04 | (type >> 8));
  out[1] = low_byte(type);
  out[4] = static_cast<std::uint8_t>(length >> 8);
  out[5] = static_cast<std::uint8_t>(length);
  out[9] = 7;  // any id
  std::ranges::copy(body, out.begin() + kHeaderBytes);
  return out;
}

class RecordedLlrp : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kVectors / "sllurp")) {
      GTEST_SKIP() << "no recorded vectors at " << kVectors;
    }
  }
  static void expect_folder_again(const std::string& folder, std::size_t at_least) {
    const auto all = files(folder, ".bin");
    EXPECT_GE(all.size(), at_least);
    for (const fs::path& path : all) {
      expect_same_bytes_again(path, bytes_of(path));
    }
  }
};

TEST_F(RecordedLlrp, SllurpIsUnderstoodAndEncodedAgainByteForByte) {
  expect_folder_again("sllurp", 80);
}
TEST_F(RecordedLlrp, PyllrpIsUnderstoodAndEncodedAgainByteForByte) {
  expect_folder_again("pyllrp", 40);
}
TEST_F(RecordedLlrp, LlrpjsIsUnderstoodAndEncodedAgainByteForByte) {
  expect_folder_again("llrpjs", 16);
}
TEST_F(RecordedLlrp, EventsOfARealSpeedwayAreUnderstoodAndEncodedAgainByteForByte) {
  expect_folder_again("r420_recorded", 2);
}

TEST_F(RecordedLlrp, BodiesOfARealSpeedwayAreUnderstoodAndEncodedAgainByteForByte) {
  auto all = files("edgex", ".bytes");
  const auto reports = files("edgex/roAccessReports", ".bytes");
  all.insert(all.end(), reports.begin(), reports.end());
  EXPECT_EQ(all.size(), 15u);
  for (const fs::path& path : all) {
    expect_same_bytes_again(path, with_header(path));
  }
}

TEST_F(RecordedLlrp, CapabilitiesOfARealSpeedwayTellItsHopTableAndPowers) {
  FrameHeader header;
  const auto message =
      decode_all(with_header(kVectors / "edgex/GetReaderCapabilitiesResponse-000.bytes"), header);
  ASSERT_TRUE(message);
  // The values are those of the recorder's own decoding, GetReaderCapabilitiesResponse-000.json.
  const auto& capabilities = std::get<GetReaderCapabilitiesResponse>(*message);
  ASSERT_TRUE(capabilities.general && capabilities.llrp && capabilities.regulatory && capabilities.c1g2);
  EXPECT_EQ(capabilities.general->antennas, 4);
  EXPECT_EQ(capabilities.general->manufacturer, kImpinj);
  EXPECT_EQ(capabilities.general->model, 2001002u);
  EXPECT_EQ(capabilities.general->firmware, "5.14.0.240");
  EXPECT_THAT(capabilities.general->sensitivities, SizeIs(42));
  EXPECT_EQ(capabilities.llrp->access_specs, 1508u);
  EXPECT_EQ(capabilities.llrp->ro_specs, 1u);
  const UhfBand& band = capabilities.regulatory->uhf.value();
  EXPECT_EQ(band.powers.front(), (TransmitPower{1, 1000}));
  EXPECT_EQ(band.powers.back(), (TransmitPower{81, 3000}));
  ASSERT_THAT(band.frequencies.hop_tables, SizeIs(1));
  const auto& hops = band.frequencies.hop_tables[0].frequencies_khz;
  ASSERT_THAT(hops, SizeIs(50));
  EXPECT_THAT(std::vector(hops.begin(), hops.begin() + 3), ElementsAre(909250u, 908250u, 925750u));
  EXPECT_EQ(hops.back(), 904750u);
  EXPECT_TRUE(capabilities.c1g2->block_write);
  EXPECT_FALSE(capabilities.c1g2->block_erase);
}

TEST_F(RecordedLlrp, AnInventoryReportTellsPhaseRssiAndDoppler) {
  FrameHeader header;
  const auto message =
      decode_all(bytes_of(kVectors / "sllurp/inventory_020_r2c_RO_ACCESS_REPORT.bin"), header);
  ASSERT_TRUE(message);
  // The values are those of the dissection beside it, inventory_020_r2c_RO_ACCESS_REPORT.txt.
  const auto& report = std::get<RoAccessReport>(*message);
  ASSERT_THAT(report.tags, SizeIs(1));
  const TagReport& tag = report.tags[0];
  EXPECT_EQ(tag.epc_96->bytes[11], 0x01);
  EXPECT_EQ(tag.antenna_id, 1);
  EXPECT_EQ(tag.channel_index, 6);
  EXPECT_EQ(tag.peak_rssi_dbm, -52);
  EXPECT_EQ(tag.first_seen_utc_us, 1795312911062070u);
  EXPECT_EQ(tag.phase_angle, ImpinjPhaseAngle{2162});
  EXPECT_EQ(tag.impinj_rssi, ImpinjPeakRssi{-5221});
  EXPECT_TRUE(tag.doppler);
}

/// Requests that the layout alone shows to be wrong; the others are wrong for a reader in a certain state.
struct Malformed {
  const char* file;
  Fault fault;
};
constexpr Malformed kMalformed[] = {
    {"00_unknown_message_type", Fault::kUnknownMessage},
    {"01_version_2_get_supported_version", Fault::kUnsupportedVersion},
    {"02_version_2_known_type", Fault::kUnsupportedVersion},
    {"03_version_7", Fault::kUnsupportedVersion},
    {"05_capabilities_no_body", Fault::kTruncated},
    {"06_capabilities_value_9", Fault::kBadField},
    {"07_config_value_200", Fault::kBadField},
    {"08_config_truncated", Fault::kTruncated},
    {"09_set_config_unknown_parameter", Fault::kUnknownParameter},
    {"10_set_config_unexpected_parameter", Fault::kUnexpectedParameter},
    {"11_set_config_parameter_too_long", Fault::kBadParameterLength},
    {"12_set_config_parameter_length_zero", Fault::kBadParameterLength},
    {"13_set_config_duplicate_keepalive", Fault::kDuplicateParameter},
    {"17_add_rospec_no_boundary", Fault::kMissingParameter},
    {"18_add_rospec_no_aispec", Fault::kMissingParameter},
    {"19_add_rospec_no_inventory_spec", Fault::kMissingParameter},
    {"23_add_rospec_start_trigger_77", Fault::kBadField},
    {"24_add_rospec_report_trigger_9", Fault::kBadField},
    {"25_add_rospec_unknown_parameter_inside", Fault::kUnknownParameter},
    {"26_add_rospec_empty", Fault::kMissingParameter},
    {"27_add_rospec_stray_bytes", Fault::kTrailingBytes},
    {"36_delete_rospec_short", Fault::kTruncated},
    {"47_add_access_no_tagspec", Fault::kMissingParameter},
    {"53_custom_message_short", Fault::kTruncated},
};

TEST_F(RecordedLlrp, MalformedRequestsAreToldByName) {
  std::map<std::string, Fault> expected;
  for (const Malformed& each : kMalformed) {
    expected.emplace(each.file, each.fault);
  }
  for (const fs::path& path : files("llrp_malformed", ".bin")) {
    FrameHeader header;
    const auto message = decode_all(bytes_of(path), header);
    const auto wanted = expected.find(path.stem().string());
    if (wanted == expected.end()) {
      EXPECT_TRUE(message) << path.filename();
    } else {
      ASSERT_FALSE(message) << path.filename();
      EXPECT_EQ(message.error().fault, wanted->second)
          << path.filename() << ": " << name_of(message.error().fault);
      EXPECT_NE(status_of(message.error()).code, StatusCode::kSuccess);
      expected.erase(wanted);
    }
  }
  EXPECT_TRUE(expected.empty());
}

}  // namespace
}  // namespace sensotwin::robot::llrp

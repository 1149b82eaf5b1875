// SPDX-License-Identifier: MIT
// node inventory.js HOST PORT: takes inventory with the npm package llrpjs, somebody else's client. Prints the
// EPCs of the first ten reports, one a line, closes in order and ends with 0.
"use strict";
const { LLRPClient, LLRPCore } = require("llrpjs");

const [host, port] = [process.argv[2], Number(process.argv[3])];
const kReports = 10;
const kRoSpecId = 123;
const roSpec = {
  id: 1,
  type: "ADD_ROSPEC",
  data: {
    ROSpec: {
      ROSpecID: kRoSpecId,
      Priority: 0,
      CurrentState: "Disabled",
      ROBoundarySpec: {
        ROSpecStartTrigger: { ROSpecStartTriggerType: "Null" },
        ROSpecStopTrigger: { ROSpecStopTriggerType: "Null", DurationTriggerValue: 0 },
      },
      AISpec: {
        AntennaIDs: [1, 2],
        AISpecStopTrigger: { AISpecStopTriggerType: "Null", DurationTrigger: 0 },
        InventoryParameterSpec: { InventoryParameterSpecID: 1, ProtocolID: "EPCGlobalClass1Gen2" },
      },
      ROReportSpec: {
        ROReportTrigger: "Upon_N_Tags_Or_End_Of_ROSpec",
        N: 1,
        TagReportContentSelector: {
          EnableROSpecID: 1, EnableSpecIndex: 1, EnableInventoryParameterSpecID: 1, EnableAntennaID: 1,
          EnableChannelIndex: 1, EnablePeakRSSI: 1, EnableFirstSeenTimestamp: 1, EnableLastSeenTimestamp: 1,
          EnableTagSeenCount: 1, EnableAccessSpecID: 1,
        },
      },
    },
  },
};

const reader = new LLRPClient({ host, port });
const fail = (what) => {
  console.error(what);
  process.exit(1);
};
// It waits for ever when an answer does not come.
setTimeout(() => fail("nothing within 20 s"), 20000).unref();

let enough = () => {};
const reported = new Promise((resolve) => (enough = resolve));
const epcs = [];
reader.on("error", (error) => fail(error));
reader.on("RO_ACCESS_REPORT", (message) => {
  for (const tag of [message.getTagReportData()].flat()) {
    epcs.push(tag.getEPCParameter().getEPC());
  }
  if (epcs.length >= kReports) enough();
});

const ask = async (request) => {
  const answer = await reader.transact(request);
  const status = answer.getLLRPStatus().getStatusCode();
  if (status !== "M_Success") fail(`${answer.getName()}: ${status}`);
};

(async () => {
  await reader.connect();
  const hello = await reader.recv(7000);
  const attempt = hello.getReaderEventNotificationData().getConnectionAttemptEvent();
  if (attempt.getStatus() !== "Success") fail(`refused: ${attempt.getStatus()}`);
  await ask(new LLRPCore.DELETE_ROSPEC({ data: { ROSpecID: 0 } }));
  await ask(new LLRPCore.SET_READER_CONFIG({ data: { ResetToFactoryDefault: true } }));
  await ask(new LLRPCore.GET_READER_CAPABILITIES({ data: { RequestedData: "All" } }));
  await ask(new LLRPCore.ADD_ROSPEC(roSpec));
  await ask(new LLRPCore.ENABLE_ROSPEC({ data: { ROSpecID: kRoSpecId } }));
  await ask(new LLRPCore.START_ROSPEC({ data: { ROSpecID: kRoSpecId } }));
  await reported;
  console.log(epcs.join("\n"));
  // A report between request and answer would make it wait for ever, so the line is simply closed.
  await reader.disconnect();
  process.exit(0);
})().catch(fail);

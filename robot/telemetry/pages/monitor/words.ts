// SPDX-License-Identifier: MIT
// What happened, in a person's words, and how bad it is.
import type { LogEvent } from "./model";

export type Severity = "news" | "warn" | "bad" | "good";

/** Of events.jsonl's names; others are shown as they are spelt. */
const known: Record<string, [Severity, string]> = {
  tile_found: ["news", "Tile found"],
  tile_written: ["news", "Tag written"],
  write_failed: ["bad", "Tag could not be written"],
  passage_blocked_by_light: ["news", "Something seen in the way"],
  passage_blocked_by_touch: ["news", "Something touched in the way"],
  tag_missed: ["warn", "Tag missed in passing"],
  tag_recovered: ["good", "Missed tag found"],
  tag_given_up: ["warn", "No tag found here, given up"],
  detour_begun: ["news", "Detour begun"],
  detour_done: ["news", "Detour done"],
  tile_unreachable: ["warn", "No way to this tile"],
  displaced: ["warn", "Known tag read elsewhere than expected"],
  lost: ["bad", "Lost"],
  map_complete: ["good", "Map complete"],
  bump: ["news", "Bump"],
  furniture_seen: ["news", "Furniture tag read"],
  landmark_seen: ["news", "Landmark tag read"],
  device_gone: ["bad", "Device gone"],
  device_there: ["good", "Device there"],
  client_came: ["news", "Client connected"],
  client_left: ["news", "Client left"],
  placed: ["good", "Found out where it is"],
  route: ["news", "Way planned"],
  left: ["news", "Left a place"],
  tag: ["news", "Tag read"],
  strange_tag: ["warn", "Tag that the map does not know"],
  arrived: ["good", "Arrived"],
  turned_wrong: ["warn", "Faced another way than it thought"],
  elsewhere: ["warn", "Came to another place than meant"],
  waiting: ["warn", "Something stands in the way, waiting"],
  went_round: ["news", "Went round it"],
  blocked: ["warn", "Hallway blocked"],
  bumped: ["news", "Touched something"],
  turned_by_hand: ["warn", "Somebody turned it, the compass says"],
  looks_again: ["warn", "Not sure of the place, goes back for its tag"],
  goes_on: ["news", "Not sure of the place, its way leads straight on"],
  explored: ["good", "An unknown hallway is known now"],
  map_whole: ["good", "Map whole"],
  goal: ["good", "At the goal"],
  no_way: ["bad", "No free hallway leads to the goal"],
  only_by_unknown: ["bad", "Only an unknown hallway might lead there"],
  tag_reached: ["good", "Destination reached"],
  tag_skipped: ["warn", "Destination skipped"],
  leg_begun: ["news", "On the way to the next destination"],
  tag_heard: ["news", "Tag heard"],
  tag_heard_again: ["good", "Tag heard again"],
  cables_doubted: ["warn", "Cables perhaps not swapped: tags are sought anew"],
  tag_silent: ["warn", "Tag not heard any more"],
  tag_missing: ["warn", "Tag not heard where it should be"],
  tag_found: ["good", "Place of a tag known"],
  tag_lost: ["warn", "Place of a tag lost"],
  tag_moved: ["warn", "Tag hangs elsewhere now"],
  order_doubtful: ["warn", "The list's order is doubted"],
  order_exchanged: ["warn", "Two tags of the list were exchanged"],
  reader_down: ["bad", "Tag reader gone"],
  reader_up: ["good", "Tag reader back"],
  reader_silent: ["bad", "Tag reader silent"],
  reader_back: ["good", "Tag reader back"],
  cables_swapped: ["warn", "Antenna cables exchanged; taken into account"],
  searching: ["warn", "Looking for a tag"],
  off_path: ["warn", "Off the path"],
  given_up: ["bad", "Given up"],
  leg_too_long: ["bad", "This leg takes too long"],
  stopped: ["bad", "Stopped"],
};

const marks: Record<Severity, string> = { news: "\u2022", warn: "!", bad: "\u2715", good: "\u2713" };

export function severityOf(event: LogEvent): Severity {
  return known[event.event]?.[0] ?? "news";
}

export function markOf(severity: Severity): string {
  return marks[severity];
}

export function sentence(event: LogEvent): string {
  const words = known[event.event]?.[1] ?? event.event.replaceAll("_", " ");
  const of = event.of;
  const about: string[] = [];
  if (typeof of["column"] === "number") {
    about.push(`tile ${of["column"]}, ${String(of["row"])}`);
  }
  for (const key of ["place", "side", "wire", "device", "kind"]) {
    if (typeof of[key] === "string" && of[key] !== "") {
      about.push(key === "side" ? `side ${of[key]}` : of[key]);
    }
  }
  if (event.event.startsWith("tag_") && typeof of["tag"] === "string" && of["tag"] !== "" && about.length === 0) {
    about.push(of["tag"]);
  }
  return about.length > 0 ? `${words}: ${about.join(", ")}` : words;
}

/** What the program says of the cause, empty where it says nothing. */
export function reason(event: LogEvent): string {
  const why = event.of["why"];
  return typeof why === "string" && why !== "" ? ` (${why})` : "";
}

export function clock(seconds: number): string {
  const whole = Math.max(0, Math.floor(seconds));
  const part = (n: number) => String(n).padStart(2, "0");
  const hours = Math.floor(whole / 3600);
  const rest = `${part(Math.floor((whole % 3600) / 60))}:${part(whole % 60)}`;
  return hours > 0 ? `${hours}:${rest}` : rest;
}

// SPDX-License-Identifier: MIT
// What the page asks the server (twin/trace/trace_session.hpp).
import { read, Refused, write } from "../../../robot/telemetry/pages/common/http";
import type { FileProblem } from "./files";
import type { Letter, Plan } from "./model";

export interface FileEntry {
  name: string;
  kind: "tracing" | "hallways" | "scene" | "map" | "picture";
}
export interface Opened {
  name: string;
  document?: Record<string, unknown>;
  hallways?: Record<string, unknown>;
  hallways_file?: string;
  plan?: Plan;
  stamps?: Record<string, string>;
  note?: string;
}
export interface SessionAnswer {
  folder: string;
  files: FileEntry[];
  name: string;
  hallways_file: string;
  opened: Opened | null;
}
export interface CheckAnswer {
  sound: boolean;
  problems: FileProblem[];
  text: string;
}
export interface RouteAnswer {
  found: boolean;
  reason?: string;
  start?: string;
  start_words?: string;
  steps?: { from: string; exit: Letter; to: string; length_m: number | null }[];
  words?: string[];
  cost?: number;
  by_length?: boolean;
}
export interface SceneAnswer extends CheckAnswer {
  tile_m?: number;
  tile_origin_m?: [number, number];
  tiles?: [number, number][];
  tile_count?: number;
  start?: [number, number, number];
}
export interface SaveAnswer {
  stamps?: Record<string, string>;
  draft?: boolean;
  problems?: FileProblem[];
  conflicts?: string[];
  refused?: string;
}

/** A refusal's sentence; the server sends it as JSON, and what lies before it (a lost token) as text. */
function sentence(text: string): string {
  try {
    const said = JSON.parse(text) as { error?: string; refused?: string };
    return said.error ?? said.refused ?? text;
  } catch {
    return text;
  }
}

async function asked<T>(call: () => Promise<Response>): Promise<T> {
  try {
    return (await (await call()).json()) as T;
  } catch (error) {
    if (error instanceof Refused) {
      throw new Refused(error.status, sentence(error.message));
    }
    throw new Error("twin trace does not answer: was it ended?");
  }
}

export const session = () => asked<SessionAnswer>(() => read("/api/session"));
export const pictureUrl = (plan: Plan) => `/api/plan?id=${encodeURIComponent(plan.id)}`;

function post<T>(what: string, body: unknown): Promise<T> {
  return asked<T>(() => write("POST", `/api/${what}`, JSON.stringify(body), "application/json"));
}
export const open = (name: string) => post<Opened>("open", { name });
export const check = (document: unknown) => post<CheckAnswer>("check", { document });
export const route = (document: unknown, from: string, to: string, blocked: [string, Letter][]) =>
  post<RouteAnswer>("route", { document, from, to, blocked });
export const upload = (file: File) =>
  asked<Opened>(() =>
    write("POST", `/api/upload?name=${encodeURIComponent(file.name)}`, file, "application/octet-stream"),
  );

export interface Naming {
  name: string;
  hallways_file: string;
}
export const scene = (document: unknown, naming: Naming) => post<SceneAnswer>("scene", { document, ...naming });

/** Conflicts and a scene's mistakes are answers too, not failures. */
export async function save(
  document: unknown,
  naming: Naming,
  how: { scene: boolean; overwrite: boolean; stamps: Record<string, string> },
): Promise<SaveAnswer> {
  try {
    const response = await write(
      "POST",
      "/api/save",
      JSON.stringify({ document, ...naming, ...how }),
      "application/json",
    );
    return (await response.json()) as SaveAnswer;
  } catch (error) {
    if (!(error instanceof Refused)) {
      throw new Error("twin trace does not answer: was it ended? Nothing was saved.");
    }
    if (error.status === 409 || (error.status === 422 && error.message.includes('"refused"'))) {
      return JSON.parse(error.message) as SaveAnswer;
    }
    throw new Refused(error.status, sentence(error.message));
  }
}

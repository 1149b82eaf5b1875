// SPDX-License-Identifier: MIT
// Requests to the program that served this page. Its answers to errors are a line of plain text.

export class Refused extends Error {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
  }
}

async function checked(response: Response): Promise<Response> {
  if (!response.ok) {
    throw new Refused(response.status, (await response.text()).trim() || `status ${response.status}`);
  }
  return response;
}

export async function read(path: string): Promise<Response> {
  return checked(await fetch(path, { credentials: "same-origin" }));
}

/** Anything that changes something. The header is what a page of another site cannot send (web/site.hpp). */
export async function write(method: "POST" | "PUT", path: string, body: BodyInit, type: string): Promise<Response> {
  return checked(
    await fetch(path, {
      method,
      body,
      credentials: "same-origin",
      headers: { "Content-Type": type, "X-SensoTwin": "1" },
    }),
  );
}

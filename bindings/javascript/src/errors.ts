// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The errors of the library.

/** The statuses of the library. Their values never change. */
export const Status = {
  NULL_ARGUMENT: 1,
  INVALID_ARGUMENT: 2,
  NOT_FINITE: 3,
  DEGENERATE: 4,
  NOT_SIMPLE: 5,
  BUFFER_TOO_SMALL: 6,
  RANGE: 7,
  PARSE: 8,
  NO_MEMORY: 9,
  CANCELLED: 11,
  INTERNAL: 100,
} as const;
export type Status = (typeof Status)[keyof typeof Status];

/** A call that failed. The message says why. */
export class GcvError extends Error {
  /** Why it failed. */
  readonly status: Status;

  constructor(status: Status, message: string) {
    super(message);
    this.status = status;
  }

  override get name(): string {
    return this.constructor.name;
  }

  /** The name of the status, such as "GCV_ERR_NOT_SIMPLE". */
  get statusName(): string {
    const found = Object.entries(Status).find(([, value]) => value === this.status);
    return `GCV_ERR_${found?.[0] ?? "UNKNOWN"}`;
  }
}

/** A failure that the input is to blame for: no polygon, not finite, or not what it should be. */
export class InputError extends GcvError {}

/** A computation that the progress function ended. */
export class CancelledError extends GcvError {}

const inputStatuses: Status[] = [
  Status.INVALID_ARGUMENT,
  Status.NOT_FINITE,
  Status.DEGENERATE,
  Status.NOT_SIMPLE,
  Status.PARSE,
];

/** The error for a status. @internal */
export function errorOf(status: Status, message: string): GcvError {
  if (inputStatuses.includes(status)) {
    return new InputError(status, message);
  }
  return status === Status.CANCELLED
    ? new CancelledError(status, message)
    : new GcvError(status, message);
}

/** The error for an argument that is not what it should be. @internal */
export function unfit(
  name: string,
  value: unknown,
  what: string,
  status: Status = Status.INVALID_ARGUMENT,
): InputError {
  return new InputError(status, `${name}: ${short(value)} is not ${what}`);
}

/** The error for a number that is not finite, or out of its range. @internal */
export function unfitNumber(name: string, value: number, what: string): InputError {
  return unfit(name, value, what, Number.isFinite(value) ? undefined : Status.NOT_FINITE);
}

/** The error for what cannot be a polygon, and why. @internal */
export function noPolygon(reason: string): InputError {
  return new InputError(Status.INVALID_ARGUMENT, `polygon: ${reason}`);
}

/** The same error, about the polygon of that name. @internal */
export function named(error: GcvError, name: string): GcvError {
  return errorOf(error.status, `${name}: ${error.message.replace(/^polygon: /, "")}`);
}

/** What make() gives. In messages, arguments have the names of this package. @internal */
export function renamed<T>(name: RegExp, nameHere: string, make: () => T): T {
  try {
    return make();
  } catch (error) {
    if (error instanceof GcvError && name.test(error.message)) {
      throw errorOf(error.status, error.message.replace(name, nameHere));
    }
    throw error;
  }
}

/** What make() gives, or its error. @internal */
export function caught<T>(make: () => T): T | GcvError {
  try {
    return make();
  } catch (error) {
    if (error instanceof GcvError) {
      return error;
    }
    throw error;
  }
}

/** Whether the value is an array whose buffer was transferred, or shrank away from it. @internal */
export function hasLostBuffer(value: unknown): boolean {
  if (!ArrayBuffer.isView(value) || value instanceof DataView) {
    return false;
  }
  try {
    (value as Uint8Array).keys();
    return false;
  } catch {
    return true;
  }
}

/** The key of what an object of the library is in a few words. @internal */
export const words = Symbol("words");

/** The value in a message. @internal */
export function short(value: unknown): string {
  const text = textOf(value);
  return text.length > 60 ? `${text.slice(0, 57)}...` : text;
}

function textOf(value: unknown): string {
  if (typeof value === "number") {
    return String(value);
  }
  if (typeof value === "bigint") {
    return `${value}n`;
  }
  if (typeof value === "object" && value !== null && words in value) {
    return String(value[words]);
  }
  if (hasLostBuffer(value)) {
    return "an array that has lost its buffer";
  }
  const withBigInts = (_: string, part: unknown) => (typeof part === "bigint" ? `${part}n` : part);
  try {
    return JSON.stringify(value, withBigInts) ?? String(value);
  } catch {
    // A cycle, or an array with a shape that was freed.
    return Object.prototype.toString.call(value);
  }
}

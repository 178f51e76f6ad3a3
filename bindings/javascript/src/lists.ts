// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Lists of contacts and of pairs.

import { counted, Handle, Made } from "./handle.js";
import { library, view } from "./library.js";
import { integerAt, structsOf } from "./memory.js";
import { contactStruct, pairStruct, type Contact, type Pair } from "./records.js";

/** Records of the library, in its order. It never changes. */
abstract class RecordList<T> extends Handle implements Iterable<T> {
  /** All of them; the same array at each access. */
  abstract get records(): T[];

  get length(): number {
    return this.records.length;
  }

  at(index: number): T | undefined {
    return this.records.at(index);
  }

  [Symbol.iterator](): Iterator<T> {
    return this.records[Symbol.iterator]();
  }

  /** The records, for JSON.stringify. */
  toJSON(): T[] {
    return this.records;
  }
}

/** Contacts, the nearest first. */
export class ContactList extends RecordList<Contact> {
  /** @internal */
  constructor(made: Made) {
    super(made, "gcv_contact_list_destroy");
  }

  /** @internal */
  protected override inWords(): string {
    return counted(this.length, "contact");
  }

  override get records(): Contact[] {
    return this.known("records", (pointer) =>
      structsOf(
        (...buffer) => library.gcv_contact_list_contacts(pointer, ...buffer),
        contactStruct.size,
        contactStruct.read,
      ),
    );
  }

  /** For each contact its index in the earlier list that was passed; null where it was not there. */
  get previous(): (number | null)[] {
    return this.known("previous", (pointer) =>
      structsOf(
        (...buffer) => library.gcv_contact_list_previous(pointer, ...buffer),
        8,
        (at) => (view().getInt32(at + 4, true) === -1 ? null : integerAt(at)),
      ),
    );
  }
}

/** Pairs of ids, by a, then by b. */
export class PairList extends RecordList<Pair> {
  /** @internal */
  constructor(made: Made) {
    super(made, "gcv_pair_list_destroy");
  }

  /** @internal */
  protected override inWords(): string {
    return counted(this.length, "pair");
  }

  override get records(): Pair[] {
    return this.known("records", (pointer) =>
      structsOf(
        (...buffer) => library.gcv_pair_list_pairs(pointer, ...buffer),
        pairStruct.size,
        pairStruct.read,
      ),
    );
  }
}

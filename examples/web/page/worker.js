// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The worker: all of the library's work is done here, so that the page never waits.

import { blocks } from "./compute/blocks.js";
import { trim } from "./compute/polygons.js";
import { read } from "./compute/read.js";
import { best, sheet, slide } from "./compute/sheet.js";
import { sum, text } from "./compute/sum.js";

const questions = /** @type {Record<string, (question: any) => unknown>} */ ({
  best,
  blocks,
  read,
  sheet,
  slide,
  sum,
  text,
});

onmessage = ({ data: { id, name, question } }) => {
  const start = performance.now();
  try {
    trim();
    const answer = questions[name](question);
    postMessage({ id, answer, milliseconds: performance.now() - start });
  } catch (error) {
    postMessage({ id, problem: /** @type {Error} */ (error).message });
  }
};

// The modules above wait for the library. From now on messages are heard.
postMessage({ id: 0 });

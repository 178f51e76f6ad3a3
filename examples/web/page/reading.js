// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The polygons in dropped and pasted text: Well-Known Text, GeoJSON, SVG, and paths of SVG. Here the
// text is only cut into one source for each polygon; the library reads these.

/**
 * Text that the library reads, and a matrix for its affine() if there is one.
 * @typedef {{ text: string, matrix: number[] | null }} Source
 */

/** @param {string} text @returns {Source[]} */
export function sourcesOf(text) {
  const sources = text.trimStart().startsWith("{")
    ? geometriesOf(parsed(text)).map((geometry) => plain(JSON.stringify(geometry)))
    : /<svg[\s>]/i.test(text)
      ? sourcesOfSVG(text)
      : /^\s*[Mm][\s,]*[-+.\d]/.test(text)
        ? [plain(text)]
        : sourcesOfWKT(text);
  if (sources.length === 0) {
    throw new Error(
      "There is no polygon in this text: no WKT, GeoJSON, SVG or path of SVG. Curves, and circles, " +
        "are none.",
    );
  }
  return sources;
}

/** @param {string} text @returns {Source} */
function plain(text) {
  return { text, matrix: null };
}

/** @param {string} text */
function parsed(text) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Error(`GeoJSON: ${/** @type {Error} */ (error).message}`);
  }
}

/** What GeoJSON has under a name, which must be a list. @param {any} value @param {string} name @returns {any[]} */
function listOf(value, name) {
  if (!Array.isArray(value[name])) {
    throw new Error(`GeoJSON: the ${name} of a ${value.type} are not a list.`);
  }
  return value[name];
}

/** The polygons of GeoJSON. @param {any} value @returns {object[]} */
function geometriesOf(value) {
  switch (value?.type) {
    case "FeatureCollection":
      return listOf(value, "features").flatMap(geometriesOf);
    case "Feature":
      return geometriesOf(value.geometry);
    case "GeometryCollection":
      return listOf(value, "geometries").flatMap(geometriesOf);
    case "MultiPolygon":
      return listOf(value, "coordinates").map((coordinates) => ({ type: "Polygon", coordinates }));
    case "Polygon":
      return [value];
    default:
      return [];
  }
}

/** Each POLYGON, and each part of a MULTIPOLYGON. @param {string} text */
function sourcesOfWKT(text) {
  const sources = [];
  for (const { 0: tag, 1: isMany, 2: letters, index } of text.matchAll(/\b(MULTI)?POLYGON\s*(ZM|Z|M)?\s*(?=\()/gi)) {
    const rest = text.slice(index + tag.length);
    for (const group of isMany ? groupsOf(groupsOf(rest)[0]?.slice(1, -1) ?? "") : groupsOf(rest).slice(0, 1)) {
      sources.push(plain(`POLYGON ${letters ?? ""} ${group}`));
    }
  }
  return sources;
}

/** The outermost pairs of brackets, from the start on; the last may lack its end.
 * @param {string} text */
function groupsOf(text) {
  const groups = [];
  let [depth, start] = [0, 0];
  for (let k = 0; k < text.length; ++k) {
    if (text[k] === "(" && depth++ === 0) {
      start = k;
    } else if (text[k] === ")" && --depth === 0) {
      groups.push(text.slice(start, k + 1));
    } else if (depth === 0 && !/[\s,)]/.test(text[k])) {
      return groups;
    }
  }
  return depth > 0 ? [...groups, text.slice(start)] : groups;
}

/** The paths, polygons, polylines and rectangles of a picture. Its y axis points downwards, and so is turned.
 * Nothing of the picture becomes part of the page. @param {string} text */
function sourcesOfSVG(text) {
  const picture = new DOMParser().parseFromString(text, "image/svg+xml");
  const fault = picture.querySelector("parsererror");
  if (fault !== null) {
    throw new Error(`SVG: ${(fault.querySelector("div") ?? fault).textContent?.trim()}`);
  }
  return [...picture.querySelectorAll("path, polygon, polyline, rect")]
    .filter((element) => element.closest("defs, clipPath, mask, marker, pattern, symbol") === null)
    .map((element) => {
      const { a, b, c, d, e, f } = transformOf(element);
      return { text: pathOf(element), matrix: [a, c, e, -b, -d, -f] };
    })
    .filter((source) => source.text !== "");
}

/** @param {Element} element */
function pathOf(element) {
  const number = (/** @type {string} */ name) => {
    const value = element.getAttribute(name) ?? "0";
    if (!/^\s*[-+.\d]/.test(value) || value.includes("%")) {
      throw new Error(`SVG: ${name}="${value}" of a ${element.localName} is not a length in units of the picture.`);
    }
    return Number.parseFloat(value);
  };
  if (element.localName === "path") {
    return element.getAttribute("d") ?? "";
  }
  if (element.localName !== "rect") {
    const points = element.getAttribute("points")?.trim() ?? "";
    return points === "" ? "" : `M ${points} Z`;
  }
  if (number("rx") !== 0 || number("ry") !== 0) {
    throw new Error("SVG: a rectangle with round corners is no polygon.");
  }
  const [width, height] = [number("width"), number("height")];
  return `M ${number("x")} ${number("y")} h ${width} v ${height} h ${-width} Z`;
}

/** The transforms of an element and all round it. @param {Element} element */
function transformOf(element) {
  let matrix = new DOMMatrix();
  for (let at = /** @type {Element | null} */ (element); at !== null; at = at.parentElement) {
    const transform = at.getAttribute("transform");
    if (transform !== null) {
      const group = document.createElementNS("http://www.w3.org/2000/svg", "g");
      group.setAttribute("transform", transform);
      const own = group.transform.baseVal.consolidate()?.matrix;
      matrix = own === undefined ? matrix : DOMMatrix.fromMatrix(own).multiply(matrix);
    }
  }
  return matrix;
}

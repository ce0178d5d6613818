// SPDX-License-Identifier: Apache-2.0
"use strict";

function halfToFloat(bits) {
  const sign = bits & 0x8000 ? -1 : 1;
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  if (exponent === 31) return fraction ? NaN : sign * Infinity;
  if (exponent === 0) return sign * fraction * 2 ** -24;
  return sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}

const halfTable = Float32Array.from({ length: 65536 }, (_, bits) => halfToFloat(bits));

function bytesFromBase64(text) {
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * The planes of an embedded layer as floats, plane after plane, row by row from the top left: the
 * inverse of pack_planes() in reports/embedded_layers.cpp.
 */
async function unpackLayer({ id, width, exponent }) {
  const packed = bytesFromBase64(document.getElementById(id).textContent.trim());
  const bytes = await inflate(packed);
  const count = bytes.length / 2;
  const values = new Float32Array(count);
  const unit = 2 ** exponent;
  let bits = 0;
  for (let i = 0; i < count; ++i) {
    if (i % width === 0) bits = 0;
    bits = (bits + ((bytes[i] << 8) | bytes[count + i])) & 0xffff;
    values[i] = halfTable[bits] * unit;
  }
  return values;
}

"use strict";

// Turns the texts of the page back into numbers.

/** The bytes of an element of the page. */
async function bytesOf(id) {
  const text = atob(document.getElementById(id).textContent);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < packed.length; ++i) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Reads consecutive numbers, the lowest byte first. */
class ByteReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.place = 0;
  }

  byte() {
    return this.bytes[this.place++];
  }

  whole() {
    return this.wholes(1)[0];
  }

  wholes(count) {
    return new Uint32Array(this.take(4 * count));
  }

  floats(count) {
    return new Float32Array(this.take(4 * count));
  }

  take(size) {
    this.place += size;
    return this.bytes.slice(this.place - size, this.place).buffer;
  }
}

/** The whole numbers of a column, frame after frame, from their differences. */
function readCodes(reader, itemCount, frameCount) {
  const order = reader.byte(), planes = reader.byte(), total = itemCount * frameCount;
  const codes = new Int32Array(total), {bytes} = reader;
  for (let plane = 0; plane < planes; ++plane) {
    const begin = reader.place + plane * total, shift = 8 * plane;
    for (let i = 0; i < total; ++i) codes[i] |= bytes[begin + i] << shift;
  }
  reader.place += planes * total;
  for (let i = 0; i < total; ++i) codes[i] = (codes[i] >>> 1) ^ -(codes[i] & 1);
  for (let sum = 0; sum < order; ++sum)
    for (let i = itemCount; i < total; ++i) codes[i] += codes[i - itemCount];
  return codes;
}

/** The values that codes stand for: multiples of a step, or the upper halves of floats. */
function valuesOf(codes, step) {
  if (step > 0) return Float32Array.from(codes, (code) => code * step);
  return new Float32Array(Int32Array.from(codes, (code) => code << 16).buffer);
}

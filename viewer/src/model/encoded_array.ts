import type { EncodedArray } from './report_data';

interface Arrays {
  f32: Float32Array;
  i8: Int8Array;
  u16: Uint16Array;
  u32: Uint32Array;
}

const bytesPerNumber = { f32: 4, i8: 1, u16: 2, u32: 4 } as const;

function bytesOf(base64: string): ArrayBuffer {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

/**
 * The numbers of an encoded array. Throws if the array does not have the expected type, or if its size does not fit its
 * shape.
 */
export function decoded<T extends keyof Arrays>(array: EncodedArray, type: T): Arrays[T] {
  if (array.type !== type) throw new Error(`an array of ${array.type} stands where ${type} was expected`);
  const buffer = bytesOf(array.base64);
  const count = array.shape.reduce((product, size) => product * size, 1);
  if (buffer.byteLength !== count * bytesPerNumber[type])
    throw new Error(`an array of shape ${array.shape.join(' x ')} has ${buffer.byteLength} bytes`);
  const make = {
    f32: () => new Float32Array(buffer),
    i8: () => new Int8Array(buffer),
    u16: () => new Uint16Array(buffer),
    u32: () => new Uint32Array(buffer),
  };
  return make[type]() as Arrays[T];
}

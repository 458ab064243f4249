import { describe, expect, it } from 'vitest';
import { decoded } from '../../src/model/encoded_array';
import { parseReportData } from '../../src/model/report_data';
import { smallReport } from '../support/small_report';

describe('decoded', () => {
  it('reads the bytes in little endian', () => {
    expect([...decoded({ type: 'f32', shape: [2], base64: 'AACAPwAAAMA=' }, 'f32')]).toEqual([1, -2]);
    expect([...decoded({ type: 'u16', shape: [2], base64: 'AQADAg==' }, 'u16')]).toEqual([1, 0x0203]);
    expect([...decoded({ type: 'u32', shape: [1], base64: 'BAMCAQ==' }, 'u32')]).toEqual([0x01020304]);
    expect([...decoded({ type: 'i8', shape: [3], base64: '/wAB' }, 'i8')]).toEqual([-1, 0, 1]);
    expect([...decoded({ type: 'u32', shape: [0], base64: '' }, 'u32')]).toEqual([]);
  });
  it('refuses another type or size', () => {
    expect(() => decoded({ type: 'u16', shape: [2], base64: 'AQADAg==' }, 'f32')).toThrow('u16');
    expect(() => decoded({ type: 'u16', shape: [3], base64: 'AQADAg==' }, 'u16')).toThrow('3');
  });
});

describe('parseReportData', () => {
  it('refuses what is no data of a report, or of another version', () => {
    expect(parseReportData(JSON.stringify(smallReport())).title).toBe('t');
    expect(() => parseReportData('{}')).toThrow('no data');
    expect(() => parseReportData(JSON.stringify({ ...smallReport(), format_version: 2 }))).toThrow('version 2');
  });
});

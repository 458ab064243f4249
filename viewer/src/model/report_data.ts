// The data that foramen writes into the page, as docs/report.md defines them.

export const formatVersion = 1;

export interface EncodedArray {
  type: 'f32' | 'i8' | 'u16' | 'u32';
  shape: number[];
  base64: string;
}

/** Points on triangles of the landmarks, with three barycentric weights each. */
export interface EncodedPlaces {
  triangles: EncodedArray;
  weights: EncodedArray;
}

export interface MarkData {
  name: string;
  kind: 'point' | 'open' | 'closed';
  colour: string;
  scatter_mm: number;
  /** The shapes that have the mark, and the points of all of them, shape after shape. */
  shapes: EncodedArray;
  places: EncodedPlaces;
}

export interface Statement {
  heading: string;
  text: string;
}

export interface Chart {
  title: string;
  x_label: string;
  y_label: string;
  series: { name: string; x: number[]; y: number[]; error: number[] }[];
}

export interface Table {
  title: string;
  note: string;
  header: string[];
  rows: string[][];
}

export type Vector = [number, number, number];

export interface NamedView {
  name: string;
  from: Vector;
  up: Vector;
}

export interface TrainingShape {
  name: string;
  subject: string | null;
  is_reference: boolean;
  scores: number[];
  error: EncodedArray;
  plain_flips: EncodedArray;
  confirmed_flips: EncodedArray;
  mean_mm: number;
  p95_mm: number;
  hausdorff_mm: number;
}

export interface ReportData {
  format: string;
  format_version: number;
  foramen: string;
  title: string;
  subtitle: string;
  plain_words: Statement[];
  findings: string[];
  model: {
    space: 'LPS' | 'RAS';
    modes_of_model: number;
    variance_shares: number[];
    mean: EncodedArray;
    modes: EncodedArray;
    triangles: EncodedArray;
  };
  torus: { lattice: [[number, number], [number, number]]; turns: EncodedArray; jumps: EncodedArray };
  loops: EncodedPlaces[];
  marks: MarkData[];
  views: NamedView[];
  error_unit_mm: number;
  shapes: TrainingShape[];
  charts: Chart[];
  figures: Table[];
  differences: Table[];
  remarks: string[];
  shapes_table: Table;
  left_out: Table;
  repaired: Table;
  refit_failures: Table;
  made_by: string;
  options: Table;
  inputs: Table;
  papers: Table;
}

/**
 * Parses the text of the page's data. Throws if the text is not a report's data, or has another version of the format.
 */
export function parseReportData(text: string): ReportData {
  const data = JSON.parse(text) as ReportData;
  if (data.format !== 'foramen-report') throw new Error('the page holds no data of a report');
  if (data.format_version !== formatVersion)
    throw new Error(`the page reads data of version ${formatVersion}, but holds version ${data.format_version}`);
  return data;
}

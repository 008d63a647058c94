// The tool-change sheet: when to change which edge, and changes of one machine merged into common stops.

export interface ToolJob {
  machine: string;
  tool: string;
  operation: string;
  /** Cutting minutes of one part. */
  cutting_min: number;
  /** Age at which an edge is changed, cutting minutes; null: at failure only. */
  age_min: number | null;
}
export interface SheetRow extends ToolJob {
  /** Whole parts that an edge makes; null: at failure only. */
  every: number | null;
  /** The same, brought down to a multiple of the machine's common window. */
  merged: number | null;
  /** Cutting minutes thrown away at a merged change, of the age allowed. */
  lost: number;
}

/**
 * Whole parts per edge, and per machine a common window: the smallest number of parts among its tools. Other tools are
 * changed at the last window that they reach, so that the machine stops once for several edges and no edge grows older
 * than allowed. An age shorter than a part means an edge per part.
 */
export function changeSheet(jobs: readonly ToolJob[]): SheetRow[] {
  const every = (j: ToolJob) => (j.age_min === null || j.cutting_min <= 0 ? null : Math.max(1, Math.floor(j.age_min / j.cutting_min + 1e-9)));
  const windows = new Map<string, number>();
  for (const j of jobs) {
    const n = every(j);
    if (n !== null) windows.set(j.machine, Math.min(n, windows.get(j.machine) ?? Infinity));
  }
  return jobs.map((j) => {
    const n = every(j);
    const window = windows.get(j.machine) ?? 1;
    const merged = n === null ? null : Math.max(window, Math.floor(n / window) * window);
    return { ...j, every: n, merged, lost: merged === null || j.age_min === null || j.age_min <= 0 ? 0 : Math.max(0, 1 - (merged * j.cutting_min) / j.age_min) };
  });
}

/** Which tools are changed at each stop of a machine within `horizon` parts: [parts, tools]. */
export function stops(rows: readonly SheetRow[], machine: string, most: number): [number, string[]][] {
  const own = rows.filter((r) => r.machine === machine && r.merged !== null);
  const window = Math.min(...own.map((r) => r.merged ?? Infinity));
  if (!Number.isFinite(window)) return [];
  return Array.from({ length: most }, (_, k) => (k + 1) * window).map((parts) => [parts, own.filter((r) => parts % (r.merged ?? 1) === 0).map((r) => r.tool)]);
}

// The views of a run's flat KPI list: machines with their states, tools, crews, cost components. KPI names are
// paths ("machine/lathe 1/state/cutting"); the name of a machine may itself hold a slash.

import type { Kpi, RunHeader } from '../types';

export interface MachineTime {
  machine: string;
  availability: Kpi | undefined;
  states: { state: string; kpi: Kpi }[];
}

export interface Entity {
  name: string;
  kpis: { key: string; kpi: Kpi }[];
}

export function find(run: Pick<RunHeader, 'kpis'>, name: string): Kpi | undefined {
  return run.kpis?.find((k) => k.name === name);
}

/** Last step of the path: "machine/lathe 1/state/cutting" -> "cutting". */
export function lastStep(name: string): string {
  return name.slice(name.lastIndexOf('/') + 1);
}

export function machineTimes(kpis: readonly Kpi[]): MachineTime[] {
  const machines = new Map<string, MachineTime>();
  const machine = (name: string): MachineTime => {
    let m = machines.get(name);
    if (!m) machines.set(name, (m = { machine: name, availability: undefined, states: [] }));
    return m;
  };
  for (const kpi of kpis) {
    const state = /^machine\/(.+)\/state\/([^/]+)$/.exec(kpi.name);
    const availability = /^machine\/(.+)\/availability$/.exec(kpi.name);
    if (state) machine(state[1] ?? '').states.push({ state: state[2] ?? '', kpi });
    else if (availability) machine(availability[1] ?? '').availability = kpi;
  }
  return [...machines.values()];
}

/** First steps of the paths that have a name and an indicator below: "machine", "tool", "crew", ... in order. */
export function entityKinds(kpis: readonly Kpi[]): string[] {
  return [...new Set(kpis.flatMap((k) => (k.name.split('/').length > 2 ? [k.name.slice(0, k.name.indexOf('/'))] : [])))];
}

/**
 * KPIs below "tool/NAME/", "crew/NAME/" and so on, one entity per name. What stands deeper ("tool/NAME/edges/used") belongs to
 * NAME as "edges/used" when NAME has indicators of its own.
 */
export function entities(kpis: readonly Kpi[], kind: string): Entity[] {
  const owner = (path: string) => path.slice(0, path.lastIndexOf('/'));
  const paths = kpis.flatMap((kpi) => (kpi.name.startsWith(`${kind}/`) && kpi.name.indexOf('/', kind.length + 1) > 0 ? [{ path: kpi.name.slice(kind.length + 1), kpi }] : []));
  const names = new Set(paths.map((p) => owner(p.path)));
  const all = new Map<string, Entity>();
  for (const { path, kpi } of paths) {
    let name = owner(path);
    for (let up = name.lastIndexOf('/'); up > 0; up = name.lastIndexOf('/', up - 1)) if (names.has(name.slice(0, up))) name = name.slice(0, up);
    let e = all.get(name);
    if (!e) all.set(name, (e = { name, kpis: [] }));
    e.kpis.push({ key: path.slice(name.length + 1), kpi });
  }
  return [...all.values()];
}

export function costComponents(kpis: readonly Kpi[]): { component: string; kpi: Kpi }[] {
  return kpis.flatMap((kpi) => {
    const match = /^cost\/([^/]+)$/.exec(kpi.name);
    return match ? [{ component: match[1] ?? '', kpi }] : [];
  });
}

/** The entry with the smallest (sign 1) or largest (sign -1) mean; entries without a mean are left out. */
export function extreme<T extends { kpi: Kpi }>(list: readonly T[], sign: 1 | -1): T | undefined {
  const known = list.filter((e) => e.kpi.mean !== null);
  return known.reduce<T | undefined>(
    (best, e) => (best === undefined || sign * (e.kpi.mean ?? 0) < sign * (best.kpi.mean ?? 0) ? e : best),
    undefined,
  );
}

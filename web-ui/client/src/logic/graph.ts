// The shop as a graph: which machines parts go through, laid out from left to right. Made from any scenario that has
// parts with routes over operations on machines; what it does not understand it leaves out.

import type { Json } from './pointer';

export interface ShopNode {
  id: string;
  /** JSON pointer of the element, for a click. */
  pointer: string;
  label: string;
  below: string;
  kind: 'source' | 'machine' | 'store';
  column: number;
  row: number;
}
export interface ShopEdge {
  from: string;
  to: string;
  /** Which part types go this way. */
  parts: string[];
  back: boolean;
}
export interface ShopGraph {
  nodes: ShopNode[];
  edges: ShopEdge[];
}

type ObjectJson = { [key: string]: Json };
const isObject = (v: Json | undefined): v is ObjectJson => typeof v === 'object' && v !== null && !Array.isArray(v);
const list = (v: Json | undefined): ObjectJson[] => (Array.isArray(v) ? v.filter(isObject) : []);
const text = (v: Json | undefined): string => (typeof v === 'string' ? v : '');

/** A route as pairs of steps; -1 is the way in, and a step beyond the last the way out. */
export interface Flow {
  operations: string[];
  pairs: [number, number][];
}

/** The route of a part: a list of operations one after the other, or a graph of steps with branches and rework. */
export function flowOf(part: ObjectJson): Flow {
  const steps = list(part['steps']);
  if (steps.length === 0) {
    const operations = Array.isArray(part['route']) ? part['route'].map(text).filter(Boolean) : [];
    return { operations, pairs: operations.length === 0 ? [] : Array.from({ length: operations.length + 1 }, (_, k) => [k - 1, k]) };
  }
  const place = new Map(steps.map((s, k) => [text(s['name']), k]));
  const target = (name: string) => (name === '' ? steps.length : (place.get(name) ?? steps.length));
  const pairs: [number, number][] = [[-1, 0]];
  steps.forEach((step, k) => {
    const next = list(step['next']);
    if (next.length === 0) pairs.push([k, k + 1]);
    for (const branch of next) pairs.push([k, target(text(branch['to']))]);
    const rework = text(step['rework']);
    if (rework !== '') pairs.push([k, target(rework)]);
  });
  return { operations: steps.map((s) => text(s['operation'])), pairs };
}

/** The machine groups that may do an operation: one, several, or those with a capability. */
export function groupsOf(operation: ObjectJson | undefined, machines: readonly ObjectJson[]): string[] {
  const one = text(operation?.['machine']);
  if (one !== '') return [one];
  const several = operation?.['machines'];
  if (Array.isArray(several) && several.length > 0) return several.map(text);
  const capability = text(operation?.['capability']);
  return capability === '' ? [] : machines.filter((m) => Array.isArray(m['capabilities']) && m['capabilities'].includes(capability)).map((m) => text(m['name']));
}

export function shopGraph(scenario: Json): ShopGraph {
  if (!isObject(scenario)) return { nodes: [], edges: [] };
  const machines = list(scenario['machines']);
  const operations = new Map(list(scenario['operations']).map((o) => [text(o['name']), o]));
  const edges = new Map<string, ShopEdge>();
  const link = (from: string, to: string, part: string) => {
    if (from === to) return;
    const key = `${from}\u0000${to}`;
    const edge = edges.get(key) ?? { from, to, parts: [], back: false };
    if (!edge.parts.includes(part)) edge.parts.push(part);
    edges.set(key, edge);
  };
  for (const part of list(scenario['parts'])) {
    const name = text(part['name']);
    const flow = flowOf(part);
    const places = (k: number): string[] =>
      k < 0 ? ['source:'] : k >= flow.operations.length ? [`store:${text(part['store'])}`] : groupsOf(operations.get(flow.operations[k] ?? ''), machines).map((g) => `machine:${g}`);
    for (const [a, b] of flow.pairs) for (const from of places(a)) for (const to of places(b)) link(from, to, name);
  }

  const nodes: ShopNode[] = [];
  if (edges.size > 0) nodes.push({ id: 'source:', pointer: '/parts', label: '', below: '', kind: 'source', column: 0, row: 0 });
  machines.forEach((m, k) => {
    const count = typeof m['count'] === 'number' ? m['count'] : 1;
    nodes.push({ id: `machine:${text(m['name'])}`, pointer: `/machines/${k}`, label: text(m['name']), below: [count === 1 ? '' : `× ${count}`, text(m['model'])].filter(Boolean).join(' '), kind: 'machine', column: 0, row: 0 });
  });
  const stores = list(scenario['stores']);
  for (const id of new Set([...edges.values()].map((e) => e.to).filter((to) => to.startsWith('store:')))) {
    const k = stores.findIndex((s) => `store:${text(s['name'])}` === id);
    nodes.push({ id, pointer: k < 0 ? '/stores' : `/stores/${k}`, label: id.slice(6), below: '', kind: 'store', column: 0, row: 0 });
  }
  const known = new Set(nodes.map((n) => n.id));
  const all = [...edges.values()].filter((e) => known.has(e.from) && known.has(e.to));
  place(nodes, all);
  return { nodes, edges: all };
}

/** Columns by the longest way from the source, edges that lead back left out of it; rows in the order of the file. */
function place(nodes: ShopNode[], edges: ShopEdge[]): void {
  const byId = new Map(nodes.map((n) => [n.id, n]));
  const state = new Map<string, 1 | 2>();
  const order: string[] = [];
  const visit = (id: string): void => {
    state.set(id, 1);
    for (const e of edges.filter((x) => x.from === id)) {
      if (state.get(e.to) === 1) e.back = true;
      else if (!state.has(e.to)) visit(e.to);
    }
    state.set(id, 2);
    order.unshift(id);
  };
  for (const n of nodes) if (!state.has(n.id)) visit(n.id);
  for (const id of order)
    for (const e of edges.filter((x) => x.from === id && !x.back)) {
      const to = byId.get(e.to);
      if (to) to.column = Math.max(to.column, (byId.get(id)?.column ?? 0) + 1);
    }
  const last = Math.max(0, ...nodes.map((n) => n.column));
  for (const n of nodes) if (n.kind === 'store') n.column = Math.max(n.column, last);
  const rows = new Map<number, number>();
  for (const n of nodes) {
    n.row = rows.get(n.column) ?? 0;
    rows.set(n.column, n.row + 1);
  }
}

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

/** Pairs of operation names that follow each other: a list of names is a chain; {from, to} pairs are taken as they are. */
export function routePairs(route: Json | undefined, operations: ReadonlySet<string>): { chain: string[]; pairs: [string, string][] } {
  const chain: string[] = [];
  const pairs: [string, string][] = [];
  const visit = (value: Json): void => {
    if (typeof value === 'string') {
      if (operations.has(value)) chain.push(value);
    } else if (Array.isArray(value)) value.forEach(visit);
    else if (isObject(value)) {
      const from = text(value['from']);
      const targets = Array.isArray(value['to']) ? value['to'] : [value['to']];
      if (operations.has(from)) {
        for (const target of targets) {
          const to = isObject(target) ? text(target['operation']) || text(target['name']) : text(target);
          if (operations.has(to)) pairs.push([from, to]);
        }
      } else Object.values(value).forEach(visit);
    }
  };
  if (route !== undefined && route !== null) visit(route);
  for (let k = 1; k < chain.length; ++k) pairs.push([chain[k - 1] ?? '', chain[k] ?? '']);
  const first = chain[0] ?? pairs[0]?.[0];
  return { chain: chain.length > 0 ? chain : first ? [first, ...new Set(pairs.flat())] : [], pairs };
}

export function shopGraph(scenario: Json): ShopGraph {
  if (!isObject(scenario)) return { nodes: [], edges: [] };
  const machines = list(scenario['machines']);
  const operations = list(scenario['operations']);
  const machineOf = new Map(operations.map((o) => [text(o['name']), Array.isArray(o['machine']) ? text(o['machine'][0]) : text(o['machine'])]));
  const names = new Set(machineOf.keys());
  const edges = new Map<string, ShopEdge>();
  const link = (from: string, to: string, part: string) => {
    if (from === to) return;
    const key = `${from}\u0000${to}`;
    const edge = edges.get(key) ?? { from, to, parts: [], back: false };
    if (!edge.parts.includes(part)) edge.parts.push(part);
    edges.set(key, edge);
  };
  const used = new Set<string>();
  for (const part of list(scenario['parts'])) {
    const name = text(part['name']);
    const { chain, pairs } = routePairs(part['route'], names);
    const machine = (operation: string) => `machine:${machineOf.get(operation) ?? ''}`;
    const source = 'source:';
    if (chain.length === 0) continue;
    const last = chain.at(-1) ?? '';
    const sinks = pairs.length > 0 ? [...new Set(pairs.map(([, to]) => to))].filter((to) => !pairs.some(([from]) => from === to)) : [last];
    link(source, machine(chain[0] ?? ''), name);
    for (const [from, to] of pairs) link(machine(from), machine(to), name);
    const store = text(part['store']);
    for (const sink of sinks.length > 0 ? sinks : [last]) link(machine(sink), store ? `store:${store}` : 'store:', name);
    chain.forEach((o) => used.add(machine(o)));
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

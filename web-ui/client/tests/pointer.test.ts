import { describe, expect, it } from 'vitest';
import { applyChanges, at, changesBetween, equal, join, put, steps, type Json } from '../src/logic/pointer';

const scenario: Json = { name: 'cell', 'a/b': { '~': 1 }, machines: [{ name: 'lathe', count: 2, limits: { power_kw: 4 } }, { name: 'mill', count: 1 }] };

describe('JSON pointers', () => {
  it('lead to members and entries, escaped ones too', () => {
    expect(at(scenario, '/machines/0/limits/power_kw')).toBe(4);
    expect(at(scenario, '/a~1b/~0')).toBe(1);
    expect(at(scenario, '')).toBe(scenario);
    expect(at(scenario, '/machines/7/count')).toBeUndefined();
    expect(at(scenario, '/toString')).toBeUndefined();
    expect(join('/x', 'a/~')).toBe('/x/a~1~0');
    expect(steps('/x/a~1~0')).toEqual(['x', 'a/~']);
  });
  it('put copies and leaves the original alone', () => {
    const next = put(scenario, '/machines/0/count', 3);
    expect(at(next, '/machines/0/count')).toBe(3);
    expect(at(scenario, '/machines/0/count')).toBe(2);
    expect(at(put(scenario, '/machines/0/limits', undefined), '/machines/0')).toEqual({ name: 'lathe', count: 2 });
    expect(at(put(scenario, '/machines/0', undefined), '/machines')).toHaveLength(1);
    expect(() => put(scenario, '/machines/9/count', 1)).toThrow('no such entry');
    expect(() => put(scenario, '/name/x', 1)).toThrow('no such member');
  });
  it('changes are as deep as a what-if can say', () => {
    const edits: [(s: Json) => Json, string[]][] = [
      [(s) => put(s, '/machines/0/count', 3), ['/machines/0/count']],
      [(s) => put(put(s, '/machines/0/count', 3), '/machines/1/name', 'x'), ['/machines/0/count', '/machines/1/name']],
      [(s) => put(s, '/machines/1/model', 'M'), ['/machines/1/model']],
      [(s) => put(s, '/machines/0/limits/power_kw', undefined), ['/machines/0/limits']],
      [(s) => put(s, '/machines/1', undefined), ['/machines']],
      [(s) => put(s, '/name', undefined), ['']],
      [(s) => s, []],
    ];
    for (const [edit, pointers] of edits) {
      const next = edit(scenario);
      const changes = changesBetween(scenario, next);
      expect(changes.map((c) => c.pointer)).toEqual(pointers);
      expect(equal(applyChanges(scenario, changes), next)).toBe(true);
    }
  });
  it('changes of random edits give the edited scenario back', () => {
    let state = 7;
    const random = (n: number) => (state = (state * 48271) % 2147483647) % n;
    const make = (depth: number): Json => {
      const kind = random(depth > 0 ? 6 : 4);
      if (kind === 0) return random(100);
      if (kind === 1) return `t${random(9)}`;
      if (kind === 2) return random(2) === 0;
      if (kind === 3) return null;
      if (kind === 4) return Array.from({ length: random(4) }, () => make(depth - 1));
      return Object.fromEntries(Array.from({ length: random(4) }, () => [`k${random(5)}`, make(depth - 1)]));
    };
    for (let k = 0; k < 500; ++k) {
      const [a, b] = [make(4), make(4)];
      expect(equal(applyChanges(a, changesBetween(a, b)), b)).toBe(true);
      expect(equal(a, b)).toBe(changesBetween(a, b).length === 0);
    }
  });
});

import { describe, expect, it } from 'vitest';
import lock from '../package-lock.json';

interface Locked {
  version?: string;
  resolved?: string;
  integrity?: string;
  optionalDependencies?: Record<string, string>;
}

describe('the lock file', () => {
  const packages = Object.entries(lock.packages as Record<string, Locked>).filter(([path]) => path !== '');
  it('names no registry but the public one, and every package with its hash', () => {
    for (const [path, p] of packages) {
      if (p.resolved !== undefined) expect(p.resolved, path).toMatch(/^https:\/\/registry\.npmjs\.org\//);
      expect(p.integrity, path).toMatch(/^sha512-/);
    }
  });
  // npm ci refuses a lock that leaves out the packages of other platforms.
  it('holds the packages of every platform', () => {
    const known = new Set(packages.map(([path]) => path.replace(/^.*node_modules\//, '')));
    // Only what a bundler needs to run; fsevents and the like come in by themselves.
    for (const [path, p] of packages.filter(([path]) => /node_modules\/(rollup|esbuild)$/.test(path)))
      for (const name of Object.keys(p.optionalDependencies ?? {})) expect(known.has(name), `${path} wants ${name}`).toBe(true);
  });
});

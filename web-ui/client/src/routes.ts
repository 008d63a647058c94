// Addresses: #/ #/runs/3 #/studies/1 #/report/1 #/compare/2/3/4 #/scenario/run/3 #/operations/turning #/sheet/3
// #/trace/3 #/fit #/models #/models/K117.part_cost

export interface Route {
  page: 'home' | 'run' | 'study' | 'report' | 'sheet' | 'compare' | 'scenario' | 'operations' | 'trace' | 'fit' | 'models' | 'model';
  parameters: string[];
}

const patterns: [RegExp, Route['page']][] = [
  [/^(?:#\/?)?$/, 'home'],
  [/^#\/runs\/(\d+)$/, 'run'],
  [/^#\/studies\/(\d+)$/, 'study'],
  [/^#\/report\/(\d+)$/, 'report'],
  [/^#\/sheet\/(\d+)$/, 'sheet'],
  [/^#\/compare\/(\d+(?:\/\d+){1,7})$/, 'compare'],
  [/^#\/scenario$/, 'scenario'],
  [/^#\/scenario\/(run)\/(\d+)$/, 'scenario'],
  [/^#\/scenario\/(gallery)\/([\w-]+)$/, 'scenario'],
  [/^#\/operations(?:\/([\w-]+))?$/, 'operations'],
  [/^#\/trace(?:\/(\d+))?$/, 'trace'],
  [/^#\/fit$/, 'fit'],
  [/^#\/models$/, 'models'],
  [/^#\/models\/([\w.-]+)$/, 'model'],
];

export function matchRoute(hash: string): Route | null {
  for (const [pattern, page] of patterns) {
    const match = pattern.exec(hash);
    if (match) return { page, parameters: match.slice(1).filter((p) => p !== undefined) };
  }
  return null;
}

// Addresses: #/ #/runs/3 #/studies/1 #/compare/2/3 #/models #/models/K117.part_cost

export interface Route {
  page: 'home' | 'run' | 'study' | 'compare' | 'models' | 'model';
  parameters: string[];
}

const patterns: [RegExp, Route['page']][] = [
  [/^(?:#\/?)?$/, 'home'],
  [/^#\/runs\/(\d+)$/, 'run'],
  [/^#\/studies\/(\d+)$/, 'study'],
  [/^#\/compare\/(\d+)\/(\d+)$/, 'compare'],
  [/^#\/models$/, 'models'],
  [/^#\/models\/([\w.-]+)$/, 'model'],
];

export function matchRoute(hash: string): Route | null {
  for (const [pattern, page] of patterns) {
    const match = pattern.exec(hash);
    if (match) return { page, parameters: match.slice(1) };
  }
  return null;
}

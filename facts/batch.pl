% Many jobs in one file (docs/batch.md). Files are those in this folder.
%
%   sanggwan batch facts/batch.pl -o out -j 4

defaults([time_limit(60), memory(2000), output('%.svg')]).

job(tee, draw, ['pipe_tee.pl'],
    [view(isometric), output('%.svg'), output('plans/%.pdf')]).
job(around(Degrees), draw, ['figures/fig13.pl'], [view(Degrees, 30)])
    @ Degrees in between(0, 315, 45).
job(figure(File), draw, [File], [hidden(removed)])
    @ File in glob('figures/fig1?.pl').
job(counts, check, ['two_cubes.pl'], [json]).

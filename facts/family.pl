% A family of tees: a pipe and a branch, one file for all sizes.
%
%     sanggwan draw facts/family.pl --set branch=88.9 --set lean=30 -o tee.svg
%
% Source: made up; the diameters are those of steel pipes (EN 10220, 114.3 and
% 76.1). Units: millimetres, degrees. Right-handed, z along the pipe; polygons
% counter-clockwise seen from outside.
param(pipe, 114.3).                     % outside diameters
param(branch, 76.1).
param(lean, 0).                         % of the branch, from square, degrees
param(length, 3*param(pipe)).
param(out, param(pipe)*1.2/cos(param(lean))).   % of the branch, from the axis
param(facets, 48).
param_about(pipe, [ min(20), max(1000), step(0.1),
                    text(en, 'outside diameter of the pipe'),
                    text(ko, '관의 바깥지름') ]).
param_about(branch, [ min(20), max(1000), step(0.1),
                      text(en, 'outside diameter of the branch'),
                      text(ko, '가지관의 바깥지름') ]).
param_about(lean, [ min(-60), max(60), step(1),
                    text(en, 'lean of the branch, degrees'),
                    text(ko, '가지관의 기울기, 도') ]).
segment(1, solid, named(pipe,
    cylinder(radius(param(pipe)/2), height(param(length)),
             facets(param(facets))))).
segment(2, solid, named(branch,
    at([rotate(y, 90-param(lean)), translate(0, 0, param(length)/2)],
       cylinder(radius(param(branch)/2), height(param(out)),
                facets(param(facets)))))).
title_block(name, 'Tee').

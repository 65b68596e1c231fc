% A bird of paper: two balls, a bill and a tail, one solid in many facets.
% `--faces 160` makes of it what can be folded in an evening.
%
% Source: made up.
% Units:  millimetres, right-handed; it looks along x, and z is up.
%
%     sanggwan unfold facts/patterns/bird.pl --faces 160 --tabs 6 -o bird.svg

segment(1, solid, named(bird, union([2,3,4,5]))).
segment(2, solid, at([translate(0,0,45)],
                     sphere(radius(45), facets(48)))).
segment(3, solid, at([translate(28,0,105)],
                     sphere(radius(30), facets(48)))).
segment(4, solid, at([translate(50,0,103),rotate(y,90)],
                     cone(radius(14), height(40), facets(24)))).
segment(5, solid, at([translate(-25,0,55),rotate(y,-70)],
                     cone(radius(25), height(75), facets(24)))).

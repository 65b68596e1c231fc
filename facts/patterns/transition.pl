% A transition from a square duct to a round pipe: four flat triangles, and at
% each corner a quarter of an oblique cone. It is open at both ends, and welded
% in the middle of a flat side.
%
% Source: every text book of pattern drafting; sizes made up.
% Units:  millimetres, right-handed; z is up.

segment(1, surface,
        named(transition,
              open_transition(base(rectangle(120,120)), top(circle(40)),
                              height(70)))).

% Problems for a class: the figures of two papers, four variants each.
%
%     sanggwan problems facts/problems/collection.pl -o sheets
%
% Source: H.-C. Chae, Drawing of Penetrating Lines Using Personal Computer, KSME
%         Journal 12(1), 1988, figures 8 to 14 (fig08 to fig14); H.-C. Chae and
%         I.-S. Chung, Constructing the Development of Solids by Personal
%         Computer, KSME Journal, 1989, figures 9 to 15 (dev09 to dev15).

problem(fig08, 'fig08.pl',
        [ given([front, top]), branch(2), planes(straight),
          ask(draw(penetration)),
          text(en, 'Where does the straight line go through the cone?'),
          text(ko, '직선이 원뿔을 뚫는 점을 구하여라.') ]).
problem(fig09, 'fig09.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          text(en, 'Draw the line in which the two rectangles meet.'),
          text(ko, '두 직사각형의 상관선을 그려라.') ]).
problem(fig10, 'fig10.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          ask(count(loops)), ask(develop(1)),
          ask(measure(edge(1, 1, 5), mm, 0.1)),
          part(1, en, 'upright pyramid'), part(1, ko, '수직 각뿔'),
          part(2, en, 'lying pyramid'), part(2, ko, '수평 각뿔') ]).
problem(fig11, 'fig11.pl',
        [ given([front, top, right]), planes(straight), ask(draw(penetration)),
          ask(count(loops)), ask(develop(2)),
          ask(measure(sector(2), deg, 0.1)) ]).
problem(fig12, 'fig12.pl',
        [ given([front, top]), blank(right), planes(z),
          ask(draw(penetration)),
          ask(count(loops)), ask(develop(1)), ask(develop(2)),
          ask(measure(shortest_generator(2), mm, 0.1)) ]).
problem(fig13, 'fig13.pl',
        [ given([front, top, right]), planes(y), ask(draw(penetration)),
          ask(count(loops)), ask(develop(2)),
          ask(measure(area(2), mm2, 10)) ]).
problem(fig14, 'fig14.pl',
        [ given([front, top, right]), planes(y), ask(draw(penetration)),
          ask(count(loops)), ask(develop(1)), ask(develop(2)),
          ask(measure(coordinate(2, x), mm, 0.1)) ]).
problem(dev09, 'dev09.pl',
        [ given([front, top]), ask(develop(1)),
          ask(measure(area(1), mm2, 1)) ]).
problem(dev10, 'dev10.pl',
        [ given([front, top]), ask(develop(1)),
          ask(measure(longest_generator(1), mm, 0.1)),
          part(1, en, 'oblique cone'), part(1, ko, '빗원뿔') ]).
problem(dev11, 'dev11.pl',
        [ given([front, top]), ask(develop(1)),
          ask(measure(generator(1, 1), mm, 0.1)),
          part(1, en, 'oblique elliptic cylinder'),
          part(1, ko, '빗타원기둥') ]).
problem(dev12, 'dev12.pl',
        [ given([front, top]), ask(develop(1)),
          ask(measure(volume(1), cm3, 0.1)) ]).
problem(dev13, 'dev13.pl',
        [ given([front, top]), edges(all), ask(develop(1)),
          part(1, en, 'polyhedron'), part(1, ko, '다면체') ]).
problem(dev14, 'dev14.pl',
        [ given([front, top]), edges(all), ask(develop(1)),
          part(1, en, 'polyhedron'), part(1, ko, '다면체') ]).
problem(dev15, 'dev15.pl',
        [ given([front, top, right]), planes(y), ask(draw(penetration)),
          ask(count(loops)), ask(develop(1)), ask(develop(2)),
          ask(measure(shortest_generator(2), mm, 0.1)) ]).

variant(fig08, h, [70, 80, 90, 100]).
variant(fig09, a, [20, 35, 50, 65]).
variant(fig10, a, [34, 40, 44, 48]).
variant(fig11, r, [22, 25, 28, 31]).
variant(fig12, r, [12, 14, 16, 18]).
variant(fig13, r, [22, 26, 30, 34]).
variant(fig14, e, [6, 9, 16, 20]).
variant(dev09, h, [20, 25, 30, 35]).
variant(dev10, e, [10, 20, 30, 40]).
variant(dev11, e, [10, 20, 30, 40]).
variant(dev12, r, [12, 15, 18, 21]).
variant(dev13, r, [24, 28, 32, 36]).
variant(dev14, r, [24, 28, 32, 36]).
variant(dev15, r, [20, 24, 28, 32]).

sheet('A3', [fig08, fig09, fig10, fig11, fig12, fig13, fig14],
      [angle(third)]).
sheet('A3', [dev09, dev10, dev11, dev12, dev13, dev14, dev15],
      [angle(third)]).

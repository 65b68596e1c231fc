% Problems for a class: the figures of two papers, four variants each.
%
%     sanggwan problems facts/problems/collection.pl -o sheets
%
% Source: H.-C. Chae, Drawing of Penetrating Lines Using Personal Computer, KSME
%         Journal 12(1), 1988, figures 8 to 14 (fig08 to fig14); H.-C. Chae and
%         I.-S. Chung, Constructing the Development of Solids by Personal
%         Computer, KSME Journal, 1989, figures 9 to 15 (dev09 to dev15).

problem(fig08, 'fig08.pl',
        [ given([front, top]), branch(2), ask(draw(penetration)),
          text(en, 'Where does the line go through the cone?'),
          text(ko, '직선이 원뿔을 뚫는 점을 구하여라.') ]).
problem(fig09, 'fig09.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          text(en, 'Draw the line in which the two squares meet.'),
          text(ko, '두 사각형의 상관선을 그려라.') ]).
problem(fig10, 'fig10.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          ask(count(loops)), ask(develop(1)),
          text(en, 'Draw the lines in which the two pyramids meet.'),
          text(ko, '두 각뿔의 상관선을 그려라.') ]).
problem(fig11, 'fig11.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          ask(count(loops)), ask(develop(2)),
          text(en, 'Draw the lines in which the two cones meet.'),
          text(ko, '두 원뿔의 상관선을 그려라.') ]).
problem(fig12, 'fig12.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          ask(count(loops)), ask(develop(1)), ask(develop(2)),
          text(en, 'Draw the lines in which the cylinder and the cone meet.'),
          text(ko, '원기둥과 원뿔의 상관선을 그려라.') ]).
problem(fig13, 'fig13.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          ask(develop(2)),
          text(en, 'Draw the lines in which the two cylinders meet.'),
          text(ko, '두 원기둥의 상관선을 그려라.') ]).
problem(fig14, 'fig14.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          ask(count(loops)), ask(develop(1)), ask(develop(2)),
          text(en, 'Draw the lines in which the two cylinders meet.'),
          text(ko, '두 원기둥의 상관선을 그려라.') ]).
problem(dev09, 'dev09.pl',
        [ given([front, top]), ask(develop(1)),
          text(en, 'Draw the development of the box.'),
          text(ko, '육면체의 전개도를 그려라.') ]).
problem(dev10, 'dev10.pl',
        [ given([front, top]), ask(develop(1)),
          text(en, 'Draw the development of the oblique cone.'),
          text(ko, '빗원뿔의 전개도를 그려라.') ]).
problem(dev11, 'dev11.pl',
        [ given([front, top]), ask(develop(1)),
          text(en, 'Draw the development of the oblique cylinder.'),
          text(ko, '빗타원기둥의 전개도를 그려라.') ]).
problem(dev12, 'dev12.pl',
        [ given([front, top]), ask(develop(1)),
          text(en, 'Draw the development of the hollow cylinder.'),
          text(ko, '속이 빈 원기둥의 전개도를 그려라.') ]).
problem(dev13, 'dev13.pl',
        [ given([front, top]), ask(develop(1)),
          text(en, 'Draw the development of the polyhedron.'),
          text(ko, '다면체의 전개도를 그려라.') ]).
problem(dev14, 'dev14.pl',
        [ given([front, top]), ask(develop(1)),
          text(en, 'Draw the development of the polyhedron.'),
          text(ko, '다면체의 전개도를 그려라.') ]).
problem(dev15, 'dev15.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          ask(count(loops)), ask(develop(1)), ask(develop(2)),
          text(en, 'Draw the line and the two developments.'),
          text(ko, '두 원기둥의 상관선과 전개도를 그려라.') ]).

variant(fig08, h, [70, 80, 90, 100]).
variant(fig09, a, [20, 35, 50, 65]).
variant(fig10, a, [34, 40, 44, 48]).
variant(fig11, r, [22, 25, 28, 31]).
variant(fig12, r, [12, 14, 16, 18]).
variant(fig13, r, [22, 26, 30, 34]).
variant(fig14, e, [8, 12, 16, 20]).
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

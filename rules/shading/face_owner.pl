:- module(sg_face_owner,
          [ owner/3                     % +R, +Group, -Owner
          ]).
:- use_module('../decision', [decision/2]).
/** <module> Which one of faces that lie in one another is seen (CB-7).

Where solids of one tree are flush, faces of several leaves are in one place. A
solid begins there once, whatever there is; which of these faces it shows, and
so which colour, is a decision.
*/

:- decision(owner/3, "Which one of flush faces a shaded picture shows").

%!  owner(+R, +Group:list, -Owner) is semidet.
%
%   Owner is seen where the root R begins, or behind something see-through ends:
%   one of Group, the faces of R that lie in one another there. Each is S-Face:
%   this Face, as in face_of/3, of segment S (0: of none), a leaf of R; by leaf
%   and face. What is no face of R there, for it is taken away, is not in it. A
%   decision, asked once for each Group of two or more that a picture has; by
%   default, and where a rule names none of the Group, the first.

owner(_, [Owner|_], Owner).

/* What is told to visitors names no folder of this machine. */
:- module(test_visitor_path, []).
:- use_module(library(plunit)).
:- use_module(rules(studio/visitor_path)).
:- use_module(rules(studio/protocol), [text_octets/2]).

:- begin_tests(visitor_path).

test(head, [true(Pairs == [ do-"open", error-Error,
                            file-"deep/b.pl",
                            messages-[[1,"see a.pl and c.pl"],"/other/d.pl"],
                            path-"/home/x/e.pl" ])]) :-
    paths_untold(['/home/x','/tmp/y'],
                 _{ do:"open", file:"/home/x/deep/b.pl",
                    error:_{ kind:no_file, at:["/tmp/y/a.pl",3],
                             words:_{en:"/home/x/a.pl: not there"} },
                    messages:[[1,"see /home/x/a.pl and /tmp/y/c.pl"],
                              "/other/d.pl"],
                    path:"/home/x/e.pl" },
                 "/home/x/body", Head, Body),
    assertion(Body == "/home/x/body"),
    dict_pairs(Head, _, Pairs),
    get_dict(error, Head, Error),
    assertion(( _{kind:no_file, at:["a.pl",3], words:Words} :< Error,
                _{en:"a.pl: not there"} :< Words )).
test(without, Head-Body == Same-"b") :-
    Same = _{do:"view", n:1},
    paths_untold(['/home/x'], Same, "b", Head, Body).
%   An explanation is octets.
test(explanation, Body == Wanted) :-
    text_octets("facts /h\u00e9/a.pl, /h\u00e9e/b.pl", Body0),
    text_octets("facts a.pl, /h\u00e9e/b.pl", Wanted),
    paths_untold(['/h\u00e9'], _{do:"explain"}, Body0, _, Body).
test(root, File == "/a.pl") :-
    paths_untold([/], _{do:"open", file:"/a.pl"}, "", Head, _),
    get_dict(file, Head, File).

:- end_tests(visitor_path).

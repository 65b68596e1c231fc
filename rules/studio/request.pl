:- module(sg_request,
          [ request_error/1,            % +What
            request_options/2           % +Head, -Options
          ]).
/** <module> What is wrong with a request, and its options.
*/

%!  request_error(+What) is failure.
%
%   @error request_error(What)

request_error(What) :-
    throw(error(request_error(What), _)).

%!  request_options(+Head:dict, -Options) is det.
%
%   Options are the words of a command line that Head has; none, if it has not.
%
%   @error request_error(bad_key(options, options))

request_options(Head, Options) :-
    (   get_dict(options, Head, Options0)
    ->  (   is_list(Options0)
        ->  Options = Options0
        ;   request_error(bad_key(options, options))
        )
    ;   Options = []
    ).

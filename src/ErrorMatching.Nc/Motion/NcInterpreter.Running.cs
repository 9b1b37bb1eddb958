using System.Text;

namespace ErrorMatching.Nc;

/// <content>
/// Which block runs next. A block of plain words runs at once; one that computes, branches, calls or ends is given to <see cref="NcFlow"/> before and behind its words.
/// </content>
public sealed partial class NcInterpreter
{
    /// <summary>How many blocks may run before a program counts as one that never ends: some tenths of a second's work, and more for a long file.</summary>
    private const long LeastSteps = 500_000;

    private const long StepsPerBlock = 10;

    private readonly Func<string, NcProgram?>? _library;
    private readonly CancellationToken _cancellation;
    private NcFlow? _flow;

    // The file that is being read and the place in it: the program itself, or one that it calls.
    private NcProgram _text;
    private int _at;
    private bool _ended;

    private NcFlow Flow => _flow ??= new(_program, _dialect, new()
    {
        Library = name => _library?.Invoke(name)?.In(_dialect.Syntax),
        Returned = ReturnModes,
        Steps = LeastSteps + (StepsPerBlock * _program.BlockCount),
        Cancellation = _cancellation,
    });

    private NcPath Run()
    {
        var bytes = _program.Bytes.Span[SyntaxBytes.MarkLength(_program.Bytes.Span)..];
        _at = _dialect.Syntax == NcSyntax.Siemens && bytes is [(byte)'%', ..] ? Flow.First : BehindLeader();
        using var ahead = new CancellationTokenSource();
        while (!_ended)
        {
            if ((_at & (Stretch - 1)) == 0 && ReferenceEquals(_text, _program) && CrossBorder(ahead.Token))
            {
                continue;
            }

            if (_at < _text.BlockCount)
            {
                RunBlock(_text[_at]);
            }
            else if (_flow is { } flow && !ReferenceEquals(_text, _program))
            {
                Follow(flow.AtEnd());
            }
            else
            {
                break;
            }
        }

        ahead.Cancel();
        _cancellation.ThrowIfCancellationRequested();
        return new(_program, _dialect, _motions, _problems, _placeDependents, _frames, Notes(), _flow?.Refusal, _library)
        {
            Borders = _borders,
            ToolChanges = _toolChanges,
        };
    }

    private void RunBlock(NcBlock block)
    {
        var bytes = _text.Bytes.Span;
        _block = ReferenceEquals(_text, _program) ? _at : _block;
        if (_words.TryReadPlain(bytes.Slice(block.Start, block.Length), _dialect.Syntax))
        {
            if (TryRunStraight())
            {
                _at++;
                return;
            }

            _onlyCuts &= IsCut();
            if (!ConcernsFlow())
            {
                Step();
                GoOn();
            }
            else
            {
                RunAny(bytes, block);
            }
        }
        else
        {
            RunAny(bytes, block);
        }
    }

    private void RunAny(ReadOnlySpan<byte> bytes, NcBlock block)
    {
        _onlyCuts = false;
        if (PassesSkip(bytes, block))
        {
            return;
        }

        if (FlowTrigger.Concerns(bytes.Slice(block.Start, block.Length), _dialect) && HasStatements(block))
        {
            RunWithFlow(block);
            return;
        }

        _words.ReadTokens(bytes, block, _dialect.Syntax, ValueOf);
        if (ConcernsFlow())
        {
            RunWithFlow(block);
            return;
        }

        Step();
        GoOn();
    }

    private void RunWithFlow(NcBlock block)
    {
        if (RefusesSemicolon(block))
        {
            return;
        }

        var writes = Flow.Variables.MachineWrites;
        var action = Flow.Before(_at);
        if (action == FlowAction.Words)
        {
            _words.ReadTokens(_text.Bytes.Span, block, _dialect.Syntax, ValueOf);
            if (Flow.Refusal is null)
            {
                Step();
                if (CallsMachineProgram())
                {
                    DependOnPlace();
                    Forget();
                    Flow.Variables.ForgetMachine();
                    _at++;
                    return;
                }
            }

            action = Flow.Behind(_at, Moved);
            if (action == FlowAction.Continue && Steers() && !Flow.HasSteered)
            {
                action = Flow.RefuseCall(_at, "A word of this block");
            }
        }

        if (Flow.Variables.MachineWrites != writes)
        {
            LoseOrigin();
        }

        Follow(action);
    }

    private void Follow(FlowAction action)
    {
        _ended |= action == FlowAction.Stop;
        (_text, _at) = (Flow.Program, Flow.Next);
    }

    private void GoOn()
    {
        if (_flow is { HasModalCall: true } && Moved)
        {
            Follow(_flow.Behind(_at, moved: true));
            return;
        }

        _at++;
    }

    // Plain words that call, return, end or begin a program. The end of a program that never called needs no index of it.
    private bool ConcernsFlow()
    {
        var isNamed = _words.Has('O') || (_words.Has('L') && _dialect.Syntax == NcSyntax.Siemens);
        foreach (var function in _words.Functions)
        {
            switch (_dialect.FunctionOf(function))
            {
                case FunctionRole.ProgramEnd or FunctionRole.Return when _flow is null && !_words.Has('P'):
                    _ended = true;
                    break;
                case var role when role.Steers():
                    isNamed = true;
                    break;
            }
        }

        foreach (var code in _words.Codes)
        {
            isNamed |= _dialect.MeaningOf(code).Steers();
        }

        return isNamed;
    }

    // Whether the words of the block say how the program goes on. A call by an address that is a word among others is not executed.
    private bool Steers()
    {
        var steers = _dialect.Syntax == NcSyntax.Siemens && _dialect.RoleOf((byte)'L') == LetterRole.Program
            && ((_words.Present | _words.Computed) & BlockWords.Bit('L')) != 0;
        foreach (var function in _words.Functions)
        {
            steers |= _dialect.FunctionOf(function).Steers();
        }

        foreach (var code in _words.Codes)
        {
            steers |= _dialect.MeaningOf(code).Steers();
        }

        return steers;
    }

    // Siemens writes plain addresses with an equals sign as well; they concern nobody but the interpreter.
    private bool HasStatements(NcBlock block)
    {
        if (_dialect.Syntax != NcSyntax.Siemens)
        {
            return true;
        }

        foreach (var token in _text.Tokens(block))
        {
            if (token.Kind is NcTokenKind.Keyword or NcTokenKind.Assignment or NcTokenKind.Expression or NcTokenKind.ExpressionWord or NcTokenKind.Percent
                || token is { Kind: NcTokenKind.Word, Letter: (byte)'M' or (byte)'L' } || (token.Kind == NcTokenKind.CommaWord && token.Number == default))
            {
                return true;
            }
        }

        return false;
    }

    // A program that the machine has: what it does is not known, but it is not missing.
    private bool CallsMachineProgram()
    {
        var calls = false;
        foreach (var function in _words.Functions)
        {
            calls |= _dialect.FunctionOf(function) == FunctionRole.Call;
        }

        foreach (var code in _words.Codes)
        {
            // One that runs behind every motion from here on is missing all the same: nothing would be known of any of them.
            calls |= _dialect.MeaningOf(code) is NcMeaning.Call;
        }

        return (calls && _words.Has('P') && _dialect.IsMachineProgram((int)Math.Clamp(_words.Value('P'), -1, int.MaxValue)))
            || (_dialect.Syntax == NcSyntax.Siemens && _words.Has('L') && _dialect.IsMachineProgram((int)Math.Clamp(_words.Value('L'), -1, int.MaxValue)));
    }

    private bool IsVariable(ReadOnlySpan<byte> name) => Flow.Variables.Knows(Encoding.ASCII.GetString(name).ToUpperInvariant());

    // Values of words that move nothing are not asked for: tool names, angles of rotary axes, offsets.
    private double? ValueOf(NcToken token)
    {
        var role = token.Kind == NcTokenKind.PolarWord ? LetterRole.Axis : _dialect.RoleOf(token.Letter);
        var matters = role is LetterRole.Axis or LetterRole.Center or LetterRole.Radius or LetterRole.Feed or LetterRole.G or LetterRole.M
            or LetterRole.OpeningAngle or LetterRole.MoreTurns or LetterRole.IntermediatePoint
            || token.Letter is (byte)'P' or (byte)'Q' or (byte)'L' or (byte)'R' or (byte)'K';
        return matters && token.ValueLength > 0 ? Compute(token.ValueStart, token.ValueLength) : double.NaN;
    }

    private double? Compute(int start, int length)
    {
        var decimals = _state.Inch ? _dialect.InchDecimals : _dialect.MetricDecimals;
        return !Flow.TryValue(_at, start, length, decimals, out var value) || value.Kind is NcValueKind.Unknown or NcValueKind.Text ? double.NaN : value.IsVacant ? null : value.Number;
    }
}

namespace ErrorMatching.Nc;

/// <content>
/// What depends on the machine and not on the program: whether a block behind a slash is executed, whether a semicolon ends a block, what
/// stands before the first percent sign.
/// </content>
public sealed partial class NcInterpreter
{
    private const string OnlyHere = "The result holds for this position of the switch only.";
    private const string SplitHere = "Begin a line for them, or put a comment in parentheses.";

    // Passes over a block behind a slash, or refuses it while nobody has said whether it is executed. True if it is not to be run.
    private bool PassesSkip(ReadOnlySpan<byte> bytes, NcBlock block)
    {
        var text = bytes.Slice(block.Start, block.Length);
        if (!text.Contains((byte)'/') || !BlockHead.Read(text, _dialect.Syntax).IsSkip)
        {
            return false;
        }

        if (_dialect.BlockSkip == BlockSkip.On)
        {
            Note("block-skip", "Blocks behind a slash are passed over, since block skip is stated to be on. " + OnlyHere);
            Follow(Flow.Skip(_at));
            return true;
        }

        _words.ReadTokens(bytes, block, _dialect.Syntax, ValueOf);
        if (ChangesNothing())
        {
            return false;
        }

        if (_dialect.BlockSkip == BlockSkip.Off)
        {
            Note("block-skip", "Blocks behind a slash are executed, since block skip is stated to be off. " + OnlyHere);
            return false;
        }

        Follow(Flow.Refuse(
            NcRefusalCodes.BlockSkip,
            _at,
            "the slash makes the block depend on the switch for block skip. "
                + "State the switch: blockSkip \"on\" or \"off\" in the job or in the dialect's file, "
                + "--block-skip at the console. It counts for all levels."));
        return true;
    }

    // A stop, a wait, coolant, spindle: the path and the tool are the same whether the block runs or not.
    private bool ChangesNothing()
    {
        if (_words.Statements.Count > 0 || _words.Invalid.Length > 0 || _words.Semicolon.Length > 0
            || _words.Computed != 0 || _words.IsPolar || _words.Corner != 0)
        {
            return false;
        }

        var waits = false;
        foreach (var code in _words.Codes)
        {
            var meaning = _dialect.MeaningOf(code);
            if (meaning is not (NcMeaning.Harmless or NcMeaning.Dwell))
            {
                return false;
            }

            waits |= meaning == NcMeaning.Dwell;
        }

        foreach (var function in _words.Functions)
        {
            if (_dialect.FunctionOf(function) != FunctionRole.Harmless || function == ToolChange)
            {
                return false;
            }
        }

        // The words of a wait are its time, and P belongs to a code that moves nothing.
        var still = BlockWords.Bit('N') | BlockWords.Bit('S') | (_words.Codes.Length > 0 ? BlockWords.Bit('P') : 0);
        return waits || (_words.Present & ~still) == 0;
    }

    // Where a semicolon ends the block, words behind it are executed and not followed here; where it begins a comment, another machine
    // could still execute them.
    private MotionFlags ReadSemicolon()
    {
        if (_dialect.Syntax != NcSyntax.Iso || !ReadableBlock.StandsBehind(_text.Bytes.Span, _words.Semicolon, _dialect))
        {
            return MotionFlags.None;
        }

        if (!_dialect.SemicolonEndsBlock)
        {
            Note(
                "words-behind-semicolon",
                $"Dialect {_dialect.Name} takes what stands behind a semicolon for a comment. "
                    + "A machine that ends the block there executes it.");
            return MotionFlags.None;
        }

        Forget();
        return Problem(
            "words-behind-semicolon",
            "A semicolon ends the block, and words stand behind it: they are executed and not followed. " + SplitHere,
            MotionFlags.UnknownWord);
    }

    // The same for a block that decides how the program goes on: it could go on behind the words.
    private bool RefusesSemicolon(NcBlock block)
    {
        if (_dialect is not { Syntax: NcSyntax.Iso, SemicolonEndsBlock: true } || !_text.BytesOf(block).Contains((byte)';'))
        {
            return false;
        }

        foreach (var token in _text.Tokens(block))
        {
            var bytes = _text.Bytes.Span;
            if (token.Kind == NcTokenKind.Comment && bytes[token.Start] == ';' && ReadableBlock.StandsBehind(bytes, token, _dialect))
            {
                const string Message = "a semicolon ends the block, and words stand behind it. " + SplitHere;
                Follow(Flow.Refuse(NcRefusalCodes.BadExpression, _at, Message));
                return true;
            }
        }

        return false;
    }

    private int BehindLeader()
    {
        var leader = Leader.BlocksOf(_program, _dialect);
        if (leader > 0)
        {
            Note("leader", "What stands before the first percent sign is a leader, which the control does not read.");
        }

        return leader;
    }
}

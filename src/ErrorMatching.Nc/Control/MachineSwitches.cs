namespace ErrorMatching.Nc;

/// <summary>Handles what depends on the machine, not the program: whether a block after a slash is executed, and whether a semicolon ends
/// a block.</summary>
internal sealed class MachineSwitches(BlockValues values, ProgramRun run, CoordinateLayers layers, RunResult result, BlockReader reader)
{
    private const string OnlyHere = "The result holds for this position of the switch only.";
    private const string SplitHere = "Begin a line for them, or put a comment in parentheses.";

    /// <summary>Skips a block after a slash if block skip is on; if the setting is unknown, refuses one that changes anything. True if the
    /// block must not run.</summary>
    public bool PassesSkip(NcBlock block)
    {
        var text = run.Text.BytesOf(block);
        if (!text.Contains((byte)'/') || !BlockHead.Read(text, values.Dialect.Syntax).IsSkip)
        {
            return false;
        }

        if (values.Dialect.BlockSkip == BlockSkip.On)
        {
            result.Note("block-skip", "Blocks behind a slash are passed over, since block skip is stated to be on. " + OnlyHere);
            run.Follow(run.Flow.Skip(run.At));
            return true;
        }

        reader.ReadTokens(block);
        if (ChangesNothing())
        {
            return false;
        }

        if (values.Dialect.BlockSkip == BlockSkip.Off)
        {
            result.Note("block-skip", "Blocks behind a slash are executed, since block skip is stated to be off. " + OnlyHere);
            return false;
        }

        if (run.Decide() is { } skips)
        {
            if (skips)
            {
                run.Follow(run.Flow.Skip(run.At));
            }

            return skips;
        }

        run.Follow(run.Flow.Refuse(
            NcRefusalCodes.BlockSkip,
            run.At,
            "the slash makes the block depend on the switch for block skip. "
                + "State the switch: blockSkip \"on\" or \"off\" in the job or in the dialect's file, "
                + "--block-skip at the console. It counts for all levels."));
        return true;
    }

    /// <summary>If the semicolon ends the block, words after it are executed but not followed here. If it begins a comment, another
    /// machine could still execute them.</summary>
    public MotionFlags ReadSemicolon()
    {
        if (values.Dialect.Syntax is not (NcSyntax.Iso or NcSyntax.Okuma)
            || !ReadableBlock.StandsBehind(run.Text.Bytes.Span, values.Words.Semicolon, values.Dialect))
        {
            return MotionFlags.None;
        }

        if (!values.Dialect.SemicolonEndsBlock)
        {
            result.Note(
                "words-behind-semicolon",
                $"Dialect {values.Dialect.Name} takes what stands behind a semicolon for a comment. "
                    + "A machine that ends the block there executes it.");
            return MotionFlags.None;
        }

        layers.Forget();
        return result.Problem(
            "words-behind-semicolon",
            "A semicolon ends the block, and words stand behind it: they are executed and not followed. " + SplitHere,
            MotionFlags.UnknownWord);
    }

    /// <summary>The same for a block that determines how the program continues: it could continue after the words.</summary>
    public bool RefusesSemicolon(NcBlock block)
    {
        if (values.Dialect is not { Syntax: NcSyntax.Iso or NcSyntax.Okuma, SemicolonEndsBlock: true }
            || !run.Text.BytesOf(block).Contains((byte)';'))
        {
            return false;
        }

        foreach (var token in run.Text.Tokens(block))
        {
            var bytes = run.Text.Bytes.Span;
            if (token.Kind == NcTokenKind.Comment && bytes[token.Start] == ';' && ReadableBlock.StandsBehind(bytes, token, values.Dialect))
            {
                const string Message = "a semicolon ends the block, and words stand behind it. " + SplitHere;
                run.Follow(run.Flow.Refuse(NcRefusalCodes.BadExpression, run.At, Message));
                return true;
            }
        }

        return false;
    }

    // A stop, a wait, coolant, spindle: the path and the tool are the same whether the block runs or not.
    private bool ChangesNothing()
    {
        if (values.Words.Statements.Length > 0 || values.Words.Invalid.Length > 0 || values.Words.Semicolon.Length > 0
            || values.Words.Computed != 0 || values.Words.IsPolar || values.Words.HasPolarEnd || values.Words.Corner != 0)
        {
            return false;
        }

        var waits = false;
        foreach (var code in values.Words.Codes)
        {
            var meaning = values.Dialect.MeaningOf(code);
            if (meaning is not (NcMeaning.Harmless or NcMeaning.Dwell))
            {
                return false;
            }

            waits |= meaning == NcMeaning.Dwell;
        }

        foreach (var function in values.Words.Functions)
        {
            if (values.Dialect.FunctionOf(function) != FunctionRole.Harmless || function == BlockCodes.ToolChange)
            {
                return false;
            }
        }

        // The words of a wait are its time, and P belongs to a code that moves nothing.
        var still = BlockWords.Bit('N') | BlockWords.Bit('S') | (values.Words.Codes.Length > 0 ? BlockWords.Bit('P') : 0);
        return waits || (values.Words.Present & ~still) == 0;
    }
}

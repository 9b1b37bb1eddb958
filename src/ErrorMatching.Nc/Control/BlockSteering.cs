namespace ErrorMatching.Nc;

/// <summary>What a block does besides moving: it is a command to the control, a switch of the machine skips it, it ends at a semicolon, or
/// its words decide how the program continues (they call, return, end or begin a program).</summary>
internal sealed class BlockSteering(NcControl control)
{
    private const byte SystemMark = (byte)'$';
    private const string OnlyHere = "The result holds for this position of the switch only.";
    private const string SplitHere = "Begin a line for them, or put a comment in parentheses.";

    /// <summary>Handles a line that begins with a dollar sign: a command to the control, which is no block. The dialect states what each
    /// does; one that it does not state can do anything. False if the block is none.</summary>
    public bool RunSystemCommand(NcBlock block)
    {
        var text = control.Run.Text.BytesOf(block).TrimStart((byte)' ');
        if (!control.Dialect.SystemLines || text is not [SystemMark, ..])
        {
            return false;
        }

        var length = 1;
        while (length < text.Length && (SyntaxBytes.IsNamePart(text[length]) || text[length] == SystemMark))
        {
            length++;
        }

        var name = text[..length];
        switch (control.Dialect.MeaningOf(name))
        {
            case NcMeaning.Harmless:
                break;
            case NcMeaning.OpaqueMotion:
                MoveSomewhere();
                break;
            case NcMeaning.Unsure:
                MoveSomewhere();
                control.Layers.Forget();
                break;
            default:
                control.Result.UnknownWord(NcText.Decode(name).ToUpperInvariant());
                control.Layers.Forget();
                break;
        }

        control.Run.At++;
        return true;
    }

    /// <summary>Skips a block after a slash if block skip is on; if the setting is unknown, refuses one that changes anything. True if the
    /// block must not run.</summary>
    public bool PassesSkip(NcBlock block)
    {
        var text = control.Run.Text.BytesOf(block);
        if (!text.Contains((byte)'/') || !BlockHead.Read(text, control.Dialect.Syntax).IsSkip)
        {
            return false;
        }

        if (control.Dialect.BlockSkip == BlockSkip.On)
        {
            control.Result.Note("block-skip", "Blocks behind a slash are passed over, since block skip is stated to be on. " + OnlyHere);
            control.Run.Follow(control.Run.Flow.Skip(control.Run.At));
            return true;
        }

        control.Values.Read(block);
        if (ChangesNothing())
        {
            return false;
        }

        if (control.Dialect.BlockSkip == BlockSkip.Off)
        {
            control.Result.Note("block-skip", "Blocks behind a slash are executed, since block skip is stated to be off. " + OnlyHere);
            return false;
        }

        if (control.Run.Decide() is { } skips)
        {
            if (skips)
            {
                control.Run.Follow(control.Run.Flow.Skip(control.Run.At));
            }

            return skips;
        }

        control.Run.Follow(control.Run.Flow.Refuse(
            NcRefusalCodes.BlockSkip,
            control.Run.At,
            "the slash makes the block depend on the switch for block skip. "
                + "State the switch: blockSkip \"on\" or \"off\" in the job or in the dialect's file, "
                + "--block-skip at the console. It counts for all levels."));
        return true;
    }

    /// <summary>If the semicolon ends the block, words after it are executed but not followed here. If it begins a comment, another
    /// machine could still execute them.</summary>
    public MotionFlags ReadSemicolon()
    {
        if (!control.Dialect.Ways.SemicolonMayEndBlock
            || !ReadableBlock.StandsBehind(control.Run.Text.Bytes.Span, control.Words.Semicolon, control.Dialect))
        {
            return MotionFlags.None;
        }

        if (!control.Dialect.SemicolonEndsBlock)
        {
            control.Result.Note(
                "words-behind-semicolon",
                $"Dialect {control.Dialect.Name} takes what stands behind a semicolon for a comment. "
                    + "A machine that ends the block there executes it.");
            return MotionFlags.None;
        }

        control.Layers.Forget();
        return control.Result.Problem(
            "words-behind-semicolon",
            "A semicolon ends the block, and words stand behind it: they are executed and not followed. " + SplitHere,
            MotionFlags.UnknownWord);
    }

    /// <summary>The same for a block that determines how the program continues: it could continue after the words.</summary>
    public bool RefusesSemicolon(NcBlock block)
    {
        if (control.Dialect is not { Ways.SemicolonMayEndBlock: true, SemicolonEndsBlock: true }
            || !control.Run.Text.BytesOf(block).Contains((byte)';'))
        {
            return false;
        }

        foreach (var token in control.Run.Text.Tokens(block))
        {
            var bytes = control.Run.Text.Bytes.Span;
            if (token.Kind == NcTokenKind.Comment && bytes[token.Start] == ';' && ReadableBlock.StandsBehind(bytes, token, control.Dialect))
            {
                const string Message = "a semicolon ends the block, and words stand behind it. " + SplitHere;
                control.Run.Follow(control.Run.Flow.Refuse(NcRefusalCodes.BadExpression, control.Run.At, Message));
                return true;
            }
        }

        return false;
    }

    /// <summary>True for plain words that call, return, end or begin a program. The end of a program without calls does not need the
    /// flow's index.</summary>
    public bool ConcernsFlow()
    {
        var isNamed = control.Words.Has('O') || (control.Words.Has('L') && control.Dialect.Ways.CallsByAddress);
        foreach (var function in control.Words.Functions)
        {
            switch (control.Dialect.FunctionOf(function))
            {
                case FunctionRole.ProgramEnd or FunctionRole.Return when !control.Run.HasFlow && !control.Words.Has('P'):
                    control.Run.HasEnded = true;
                    break;
                case var role when role.Steers():
                    isNamed = true;
                    break;
            }
        }

        foreach (var code in control.Words.Codes)
        {
            isNamed |= control.Dialect.MeaningOf(code).Steers();
        }

        return isNamed;
    }

    /// <summary>Whether the words of the block determine how the program continues. A call by an address that is one word among others is
    /// not executed.</summary>
    public bool HasSteeringWords()
    {
        var steers = control.Dialect.Ways.CallsByAddress && control.Dialect.RoleOf((byte)'L') == LetterRole.Program
            && ((control.Words.Present | control.Words.Computed) & BlockWords.Bit('L')) != 0;
        foreach (var function in control.Words.Functions)
        {
            steers |= control.Dialect.FunctionOf(function).Steers();
        }

        foreach (var code in control.Words.Codes)
        {
            steers |= control.Dialect.MeaningOf(code).Steers();
        }

        return steers;
    }

    /// <summary>Handles a call of a program of the machine: its effect is unknown, but it is not missing.</summary>
    public bool CallMachineProgram()
    {
        var calls = false;
        foreach (var function in control.Words.Functions)
        {
            calls |= control.Dialect.FunctionOf(function) == FunctionRole.Call;
        }

        foreach (var code in control.Words.Codes)
        {
            // A modal call still counts as missing: nothing would be known of any later motion.
            calls |= control.Dialect.MeaningOf(code) is NcMeaning.Call;
        }

        return (calls && control.Words.Has('P')
            && control.Dialect.IsMachineProgram((int)Math.Clamp(control.Words.Value('P'), -1, int.MaxValue)))
            || (control.Dialect.Ways.CallsByAddress && control.Words.Has('L')
                && control.Dialect.IsMachineProgram((int)Math.Clamp(control.Words.Value('L'), -1, int.MaxValue)));
    }

    /// <summary>Where assignments can be words (<c>X=10</c>), those matter only to the interpreter.</summary>
    public bool HasStatements(NcBlock block)
    {
        if (!control.Dialect.Ways.AssignmentsAreWords)
        {
            return true;
        }

        foreach (var token in control.Run.Text.Tokens(block))
        {
            if (token.Kind is NcTokenKind.Keyword or NcTokenKind.Assignment or NcTokenKind.Expression or NcTokenKind.ExpressionWord
                or NcTokenKind.Percent
                || token is { Kind: NcTokenKind.Word, Letter: (byte)'M' or (byte)'L' }
                    || (token.Kind == NcTokenKind.CommaWord && token.Number == default))
            {
                return true;
            }
        }

        return false;
    }

    // A stop, a wait, coolant, spindle: the path and the tool are the same whether the block runs or not.
    private bool ChangesNothing()
    {
        if (control.Words.Statements.Length > 0 || control.Words.Invalid.Length > 0 || control.Words.Semicolon.Length > 0
            || control.Words.Computed != 0 || control.Words.IsPolar || control.Words.HasPolarEnd || control.Words.Corner != 0)
        {
            return false;
        }

        var waits = false;
        foreach (var code in control.Words.Codes)
        {
            var meaning = control.Dialect.MeaningOf(code);
            if (meaning is not (NcMeaning.Harmless or NcMeaning.Dwell))
            {
                return false;
            }

            waits |= meaning == NcMeaning.Dwell;
        }

        foreach (var function in control.Words.Functions)
        {
            if (control.Dialect.FunctionOf(function) != FunctionRole.Harmless || function == BlockCodes.ToolChange)
            {
                return false;
            }
        }

        // The words of a wait are its time, and P belongs to a code that moves nothing.
        var still = BlockWords.Bit('N') | BlockWords.Bit('S') | (control.Words.Codes.Length > 0 ? BlockWords.Bit('P') : 0);
        return waits || (control.Words.Present & ~still) == 0;
    }

    private void MoveSomewhere()
    {
        control.Result.DependOnPlace();
        control.Moves.Append(MotionKind.Cycle, MotionFlags.Cycle, control.State.Position, AxisSet.All);
    }
}

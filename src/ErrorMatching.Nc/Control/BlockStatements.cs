using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Handles words of several letters (commands, cycles, addresses, variables) by the dialect's table.</summary>
internal sealed class BlockStatements(NcControl control, BlockCodes codes, CycleCalls calls)
{
    // Of the data of tools: type, edge and what concerns the radius alone. That of cutter compensation is stated apart.
    private static readonly string[] HarmlessToolData =
    [
        "$TC_DP1", "$TC_DP2", "$TC_DP6", "$TC_DP7", "$TC_DP15", "$TC_DP16", "$TC_DPCE", "$TC_TP", "$TC_MO", "$TC_MP", "$TC_DPH", "$TC_DPV",
    ];

    public MotionFlags Read()
    {
        var flags = MotionFlags.None;
        foreach (var statement in control.Words.Statements)
        {
            flags |= statement.Kind switch
            {
                NcTokenKind.Keyword => ReadKeyword(statement),
                NcTokenKind.Assignment => ReadAssignment(statement),
                NcTokenKind.Expression when control.Run.BytesOf(statement)[0] == '<' => ReadProgramName(statement),
                _ => MotionFlags.None,
            };
        }

        return flags;
    }

    private MotionFlags ReadKeyword(NcToken statement)
    {
        var name = control.Run.NameOf(statement);
        if (control.Run.Text.Bytes.Span[statement.End - 1] == ':')
        {
            return MotionFlags.None;
        }

        if (control.Dialect.IsFlow(name) || control.Dialect.IsFlow(name.TrimEnd("0123456789"u8)))
        {
            // This one is not followed; those that are followed do not get here.
            control.Layers.Forget();
            return control.Result.UnknownWord(control.Run.TextOf(statement).ToUpperInvariant());
        }

        switch (control.Dialect.MeaningOf(name))
        {
            case NcMeaning.Unknown:
                control.Layers.Forget();
                if (calls.NextIsModal)
                {
                    // Any such call runs after every motion.
                    calls.Call(statement);
                }

                return control.Result.UnknownWord(control.Run.TextOf(statement).ToUpperInvariant());
            case NcMeaning.ModalCycle:
                calls.BeginModal();
                return MotionFlags.None;
            case NcMeaning.OpaqueCall:
                control.Run.Flow.RefuseCall(control.Run.At, NcText.Decode(name).ToUpperInvariant());
                return MotionFlags.None;
            case NcMeaning.CycleCall:
                calls.Call(statement);
                return MotionFlags.None;
            case NcMeaning.MeasuringCycle:
                calls.Call(statement, measures: true);
                return MotionFlags.None;
            case NcMeaning.ArcSense:
                codes.TakeSense(control.Run.BytesOf(statement));
                TakeOversize(statement, name.Length);
                return MotionFlags.None;
            case NcMeaning.ToolDefinition:
                codes.Compensation.DefineTool(control.Run.TextOf(statement));
                return MotionFlags.None;
            case NcMeaning.OpaqueTransform when HasNoArguments(statement):
                codes.Apply(NcMeaning.OpaqueTransformOff, control.Dialect.FamilyOf(name));
                return MotionFlags.None;
            case var meaning:
                codes.Apply(meaning, control.Dialect.FamilyOf(name), IsOfCompensation(meaning) ? SpellingOf(statement) : null);
                return MotionFlags.None;
        }
    }

    private static bool IsOfCompensation(NcMeaning meaning) => meaning is NcMeaning.Approach or NcMeaning.Departure
        or (>= NcMeaning.CompensationOff and <= NcMeaning.CompensationRight)
        or (>= NcMeaning.CompensationLeftByDiameter and <= NcMeaning.DepartureNormal);

    private string SpellingOf(NcToken statement) => control.Run.TextOf(statement).ToUpperInvariant();

    // In a tool call, the word that names the sense of an arc elsewhere is what is added to the radius.
    private void TakeOversize(NcToken word, int nameLength)
    {
        var text = SpellingOf(word)[nameLength..];
        control.Intent.Oversize = double.TryParse(text, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint,
            CultureInfo.InvariantCulture, out var oversize) && text[0] is '+' or '-' ? oversize : double.NaN;
    }

    // The flow reads the name of a called program, and that at the head of a program.
    private MotionFlags ReadProgramName(NcToken statement)
    {
        foreach (var function in control.Words.Functions)
        {
            if (control.Dialect.FunctionOf(function) == FunctionRole.Call)
            {
                return MotionFlags.None;
            }
        }

        foreach (var code in control.Words.Codes)
        {
            if (control.Dialect.MeaningOf(code) is NcMeaning.Call or NcMeaning.ModalCall)
            {
                return MotionFlags.None;
            }
        }

        control.Layers.Forget();
        return control.Result.UnknownWord(control.Run.TextOf(statement));
    }

    // CYCLE800() cancels what CYCLE800(..) set.
    private bool HasNoArguments(NcToken statement)
    {
        var bytes = control.Run.BytesOf(statement);
        return bytes.IndexOf((byte)'(') is > 0 and var open && bytes[open..].IndexOfAnyExcept("() \t"u8) < 0;
    }

    private MotionFlags ReadAssignment(NcToken statement)
    {
        var bytes = control.Run.BytesOf(statement);
        if (!control.Dialect.HasMacros)
        {
            control.Layers.Forget();
            return control.Result.UnknownWord(control.Run.TextOf(statement));
        }

        if (!control.Dialect.Ways.AssignmentsAreWords)
        {
            return MotionFlags.None;
        }

        if (bytes[0] == '$')
        {
            SetMachineVariable(bytes);
            return MotionFlags.None;
        }

        var name = control.Run.NameOf(statement);
        if (Ascii.EqualsIgnoreCase(name, "RPL"u8))
        {
            var equals = bytes.IndexOf((byte)'=') + 1;
            control.Words.PlaneAngle = control.Run.Compute(statement.Start + equals, statement.Length - equals) ?? double.NaN;
            return MotionFlags.None;
        }

        switch (name.Length == 1 ? control.Dialect.RoleOf((byte)(name[0] & ~0x20)) : control.Dialect.RoleOf(name))
        {
            case LetterRole.Length:
                codes.Apply(NcMeaning.LengthOffset, 0);
                return MotionFlags.None;
            case LetterRole.OtherAxis when name.Length > 1:
                return MotionFlags.OtherAxis;
            case LetterRole.PolarEnd:
                control.State.Unknown |= control.State.Plane.Axes();
                return control.Result.UnknownWord(control.Run.TextOf(statement));
            case LetterRole.PolarRadius or LetterRole.PolarAngle or LetterRole.LineAngle:
                var role = control.Dialect.RoleOf(name);
                var at = bytes.IndexOf((byte)'=') + 1;
                var value = IsDistance(bytes[at..]) ? double.NaN
                    : control.Run.Compute(statement.Start + at, statement.Length - at) ?? double.NaN;
                switch (role)
                {
                    case LetterRole.PolarRadius: control.Words.PoleRadius = value; break;
                    case LetterRole.PolarAngle: control.Words.PoleAngle = value; break;
                    default: control.Words.LineAngle = value; break;
                }

                return MotionFlags.None;
            case LetterRole.Harmless or LetterRole.Variable:
                return MotionFlags.None;
        }

        if (control.Dialect.MeaningOf(name) is not NcMeaning.Unknown and var meaning)
        {
            codes.Apply(meaning, control.Dialect.FamilyOf(name));
            return MotionFlags.None;
        }

        if (control.Run.IsVariable(name))
        {
            return MotionFlags.None;
        }

        // It could be an axis with another name.
        control.State.Unknown = AxisSet.All;
        return control.Result.UnknownWord(control.Run.TextOf(statement));
    }

    // AC(..) and IC(..)
    private static bool IsDistance(ReadOnlySpan<byte> value)
    {
        value = value.TrimStart((byte)' ');
        return value.Length > 1 && (value[0] | 0x20) is 'a' or 'i' && (value[1] | 0x20) == 'c';
    }

    // Data of tools can change the length in force. Outputs and markers are harmless; all others can be offsets, frames and settings.
    private void SetMachineVariable(ReadOnlySpan<byte> name)
    {
        if (BeginsWithOneOf(name, ["$TC_"]))
        {
            if (!BeginsWithOneOf(name, HarmlessToolData))
            {
                codes.Apply(NcMeaning.LengthOffset, 0);
            }
        }
        else if (!BeginsWithOneOf(name, ["$A_", "$AC_MARKER", "$AC_PARAM", "$AC_TIMER"]))
        {
            if (BeginsWithOneOf(name, ["$P_"]) && !BeginsWithOneOf(name, ["$P_UIFR", "$P_UBFR", "$P_CHBFR", "$P_NCBFR", "$P_BFR"]))
            {
                codes.Apply(NcMeaning.OpaqueTransform, control.Dialect.FamilyOf("CTRANS"u8));
            }

            control.Layers.LoseOrigin();
        }
    }

    private static bool BeginsWithOneOf(ReadOnlySpan<byte> name, ReadOnlySpan<string> prefixes)
    {
        foreach (var prefix in prefixes)
        {
            if (name.Length >= prefix.Length && Ascii.EqualsIgnoreCase(name[..prefix.Length], prefix)
                && (name.Length == prefix.Length || !char.IsAsciiDigit(prefix[^1]) || !char.IsAsciiDigit((char)name[prefix.Length])))
            {
                return true;
            }
        }

        return false;
    }
}

/// <summary>Finds words that prevent following or changing a block.</summary>
internal sealed class BlockObstacles(NcControl control, BlockStatements statements, BlockSteering steering)
{
    private static readonly uint Feeds = BlockWords.Bit('F') | BlockWords.Bit('S');

    public MotionFlags Read()
    {
        var flags = MotionFlags.None;
        if (control.Words.Statements.Length > 0)
        {
            flags |= statements.Read();
        }

        if (control.Words.Invalid.Length > 0)
        {
            flags |= control.Result.UnknownWord(control.Run.TextOf(control.Words.Invalid));
            control.Layers.Forget();
        }

        if (control.Words.Semicolon.Length > 1)
        {
            flags |= steering.ReadSemicolon();
        }

        var given = control.Words.Present | control.Words.Computed;
        if ((given & control.Values.UnknownLetters) != 0)
        {
            for (var letter = 'A'; letter <= 'Z'; letter++)
            {
                flags |= (given & control.Values.UnknownLetters & BlockWords.Bit(letter)) != 0
                    ? control.Result.UnknownWord(letter.ToString())
                    : MotionFlags.None;
            }
        }

        if ((control.Words.Computed & ~Feeds) != 0 && !control.Dialect.HasMacros)
        {
            flags |= control.Result.UnknownWord("a computed value");
            control.Layers.Forget();
        }

        if ((control.Words.Computed & (BlockWords.Bit('G') | BlockWords.Bit('M'))) != 0)
        {
            control.Layers.Forget();
        }

        if ((control.Words.Repeated & BlockWords.GeometryWords) != 0)
        {
            flags |= control.Result.Problem("repeated-word",
                "A coordinate stands twice in the block; which one counts depends on the control.",
                MotionFlags.UnknownWord);
        }

        flags |= (control.Words.Computed & BlockWords.GeometryWords) != 0 ? MotionFlags.Expression : MotionFlags.None;
        flags |= control.Words.Corner != 0 ? MotionFlags.CornerWord : MotionFlags.None;
        control.State.ModalRounding = control.Words.Corner == 'M' ? control.Values.CornerLength() : control.State.ModalRounding;
        return flags | ((given & control.Values.OtherAxes) != 0 ? MotionFlags.OtherAxis : MotionFlags.None);
    }
}

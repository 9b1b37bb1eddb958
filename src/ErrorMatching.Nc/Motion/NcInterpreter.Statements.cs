using System.Text;

namespace ErrorMatching.Nc;

/// <content>Words of several letters: commands, cycles, addresses and variables, by what the dialect's table says of them.</content>
public sealed partial class NcInterpreter
{
    private MotionFlags ReadStatements()
    {
        var flags = MotionFlags.None;
        foreach (var statement in _words.Statements)
        {
            flags |= statement.Kind switch
            {
                NcTokenKind.Keyword => ReadKeyword(statement),
                NcTokenKind.Assignment => ReadAssignment(statement),
                _ => MotionFlags.None,
            };
        }

        return flags;
    }

    private MotionFlags ReadKeyword(NcToken statement)
    {
        var name = NameOf(statement);
        if (_text.Bytes.Span[statement.End - 1] == ':')
        {
            return MotionFlags.None;
        }

        if (_dialect.IsFlow(name) || _dialect.IsFlow(name.TrimEnd("0123456789"u8)))
        {
            // One that is not followed: those that are never come here.
            Forget();
            return UnknownWord(TextOf(statement).ToUpperInvariant());
        }

        switch (_dialect.MeaningOf(name))
        {
            case NcMeaning.Unknown:
                Forget();
                if (_nextCycleIsModal)
                {
                    // Whatever it is, it runs behind every motion.
                    CallCycle(statement);
                }

                return UnknownWord(TextOf(statement).ToUpperInvariant());
            case NcMeaning.ModalCycle:
                (_modalCycle, _nextCycleIsModal) = (null, true);
                return MotionFlags.None;
            case NcMeaning.CycleCall:
                CallCycle(statement);
                return MotionFlags.None;
            case NcMeaning.OpaqueTransform when HasNoArguments(statement):
                Obey(NcMeaning.OpaqueTransformOff, _dialect.FamilyOf(name));
                return MotionFlags.None;
            case var meaning:
                Obey(meaning, _dialect.FamilyOf(name));
                return MotionFlags.None;
        }
    }

    // CYCLE800() takes back what CYCLE800(..) set.
    private bool HasNoArguments(NcToken statement)
    {
        var bytes = _text.Bytes.Span.Slice(statement.Start, statement.Length);
        return bytes.IndexOf((byte)'(') is > 0 and var open && bytes[open..].IndexOfAnyExcept("() \t"u8) < 0;
    }

    private MotionFlags ReadAssignment(NcToken statement)
    {
        var bytes = _text.Bytes.Span.Slice(statement.Start, statement.Length);
        if (_dialect.Syntax != NcSyntax.Siemens)
        {
            return MotionFlags.None;
        }

        if (bytes[0] == '$')
        {
            if (!IsHarmlessMachineVariable(bytes))
            {
                LoseOrigin();
            }

            return MotionFlags.None;
        }

        var name = NameOf(statement);
        if (Ascii.EqualsIgnoreCase(name, "RPL"u8))
        {
            var equals = bytes.IndexOf((byte)'=') + 1;
            _words.PlaneAngle = Compute(statement.Start + equals, statement.Length - equals) ?? double.NaN;
            return MotionFlags.None;
        }

        switch (_dialect.RoleOf(name))
        {
            case LetterRole.OtherAxis:
                return MotionFlags.OtherAxis;
            case LetterRole.PolarEnd:
                _state.Unknown |= _state.Plane.Axes();
                return UnknownWord(TextOf(statement));
            case LetterRole.Harmless or LetterRole.Variable:
                return MotionFlags.None;
        }

        if (_dialect.MeaningOf(name) is not NcMeaning.Unknown and var meaning)
        {
            Obey(meaning, _dialect.FamilyOf(name));
            return MotionFlags.None;
        }

        if (IsVariable(name))
        {
            return MotionFlags.None;
        }

        // It could be an axis by another name.
        _state.Unknown = AxisSet.All;
        return UnknownWord(TextOf(statement));
    }

    // Tool data, outputs and markers; all others can be offsets and settings.
    private static bool IsHarmlessMachineVariable(ReadOnlySpan<byte> name)
    {
        foreach (var prefix in (ReadOnlySpan<string>)["$TC_", "$A_", "$AC_MARKER", "$AC_PARAM", "$AC_TIMER"])
        {
            if (name.Length >= prefix.Length && Ascii.EqualsIgnoreCase(name[..prefix.Length], prefix))
            {
                return true;
            }
        }

        return false;
    }

    // Offsets of the control could be anything from here on.
    private void LoseOrigin()
    {
        ForgetOrigins();
        NextFrame();
        _state.Unknown = AxisSet.All;
        DependOnPlace();
    }

    private ReadOnlySpan<byte> NameOf(NcToken statement)
    {
        var bytes = _text.Bytes.Span.Slice(statement.Start, statement.Length);
        var length = 0;
        while (length < bytes.Length && SyntaxBytes.IsNamePart(bytes[length]))
        {
            length++;
        }

        return bytes[..length];
    }
}

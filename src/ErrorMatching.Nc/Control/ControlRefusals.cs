using System.Globalization;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace ErrorMatching.Nc;

/// <summary>Compares blocks with what the control refuses (<see cref="RefusalTable"/>). A block that it refuses stops the program there:
/// nothing is known after it, and its motions are not changed.</summary>
internal sealed class ControlRefusals(NcControl control)
{
    /// <summary>Code of a note for a block that the control may refuse, as nobody has looked it up.</summary>
    public const string MayBeRefused = "may-be-refused";

    private readonly RefusalTable _table = control.Dialect.Refusals;
    private readonly StraightRefusals _straight = control.Dialect.Refusals.Straight;
    private readonly bool _isFree = control.Dialect.Refusals.Straight.IsFree;
    private readonly ulong _moves = control.Dialect.Refusals.Straight.RapidBit | control.Dialect.Refusals.Straight.LineBit;

    private static readonly ulong FeedBit = Array.Find(RefusalTable.Remembered, r => r.Letter == 'F').Bit;

    // The current block is refused.
    private bool _stops;

    /// <summary>True if a straight move of the words just read cannot be refused. Its code is then in force.</summary>
    /// <param name="hasCode">True if the block states G0 or G1.</param>
    /// <param name="isLine">True if it is G1.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool PassStraight(bool hasCode, bool isLine) => _isFree || PassGuarded(hasCode, isLine);

    private bool PassGuarded(bool hasCode, bool isLine)
    {
        ref var inForce = ref control.State.InForce;
        if (_straight.IsNever || (inForce & _straight.Excluded) != 0 || (inForce & _straight.Needed) != _straight.Needed
            || (!hasCode && _moves != 0 && (inForce & _moves) == 0)
            || (control.Words.Has('F') && !(control.Words.Value('F') > 0))
            || (_straight.ChecksNumber && control.Words.Has('N') && !IsNumber()))
        {
            return false;
        }

        if (hasCode)
        {
            inForce = (inForce & ~_table.Motion) | (isLine ? _straight.LineBit : _straight.RapidBit);
        }

        if (control.Words.Has('F'))
        {
            inForce |= FeedBit;
        }

        return true;
    }

    private bool IsNumber() => (control.Words.Integers & BlockWords.Bit('N')) != 0 && control.Words.Value('N') >= 0;

    /// <summary>Compares the words of a block, whose codes have been read, with the rules, and applies its codes.</summary>
    public MotionFlags Read()
    {
        _stops = false;
        if (_table.IsEmpty)
        {
            return MotionFlags.None;
        }

        ref var inForce = ref control.State.InForce;
        var before = inForce;
        var words = control.Words;
        UInt128 stated = 0;
        foreach (var code in words.Codes)
        {
            stated |= _table.BitOf(code);
        }

        foreach (var function in words.Functions)
        {
            stated |= _table.BitOfFunction(function);
        }

        foreach (var code in words.Codes)
        {
            inForce = _table.After(inForce, _table.BitOf(code), stated);
        }

        foreach (var function in words.Functions)
        {
            inForce = _table.After(inForce, _table.BitOfFunction(function), stated);
        }

        inForce &= ~_table.ClearedBy(stated, before);
        foreach (var (letter, bit) in RefusalTable.Remembered)
        {
            var isGiven = words.Has(letter);
            if (isGiven || (words.Computed & BlockWords.Bit(letter)) != 0)
            {
                inForce = isGiven && letter != 'T' && words.Value(letter) == 0 ? inForce & ~bit : inForce | bit;
            }
        }

        return IsOpen() ? MotionFlags.None : Compare(before, stated);
    }

    // Words of a call are arguments, and a code that is not known has words that are not known either.
    private bool IsOpen()
    {
        if (control.Intent.HasUnknownCode || (control.Words.Unknown & (BlockWords.Bit('G') | BlockWords.Bit('M'))) != 0)
        {
            return true;
        }

        foreach (var code in control.Words.Codes)
        {
            if (control.Dialect.MeaningOf(code).Steers())
            {
                return true;
            }
        }

        return false;
    }

    private MotionFlags Compare(ulong before, UInt128 stated)
    {
        var words = control.Words;
        var given = ((words.Present | words.Computed) & RefusalTable.AllLetters) | (words.IsPolar ? RefusalTable.Polar : 0);
        var inForce = control.State.InForce;
        var moves = (stated & _table.Motion) == 0 && control.Intent.Use is AxisUse.Motion or AxisUse.MachineCoordinates
            && ((given & (BlockWords.LinearAxes | control.Values.OtherAxes | RefusalTable.Polar)) != 0
                || ((given & BlockWords.CenterWords) != 0 && (inForce & (ulong)_table.ArcCodes) != 0));

        // What the block continues; where that is not known, it can be any motion.
        var continued = moves && (stated & _table.Motion) == 0 ? inForce & _table.Motion : 0;
        var surely = stated | continued;
        var maybe = surely | (moves && (stated & _table.Motion) == 0 && continued == 0 ? _table.Motion : 0);
        var block = new Block(given, stated, surely, maybe, before, inForce);
        var flags = MotionFlags.None;
        if (words.Codes.Length + words.Functions.Length > 1)
        {
            foreach (var (codes, rule) in _table.TwoOf)
            {
                if ((stated & codes) != 0 && Count(codes) > 1)
                {
                    flags |= Refuse(rule, block, Codes(codes));
                }
            }
        }

        for (var letters = given; letters != 0; letters &= letters - 1)
        {
            foreach (var rule in _table.OfLetter(BitOperations.TrailingZeroCount(letters)))
            {
                flags |= Try(rule, block);
            }
        }

        for (var codes = surely; codes != 0; codes &= codes - 1)
        {
            foreach (var rule in _table.OfCode((int)UInt128.TrailingZeroCount(codes)))
            {
                flags |= Try(rule, block);
            }
        }

        foreach (var rule in _table.Others)
        {
            flags |= Try(rule, block);
        }

        return flags;
    }

    private readonly record struct Block(uint Given, UInt128 Stated, UInt128 Surely, UInt128 Maybe, ulong Before, ulong InForce);

    private MotionFlags Try(RefusalRule rule, in Block block)
    {
        foreach (var codes in rule.Codes)
        {
            // Codes that meet must both be stated.
            if ((codes & (rule.Codes.Length > 1 ? block.Stated : block.Surely)) == 0)
            {
                return MotionFlags.None;
            }
        }

        foreach (var letters in rule.Letters)
        {
            if ((letters & block.Given) == 0)
            {
                return MotionFlags.None;
            }
        }

        foreach (var codes in rule.While)
        {
            if ((codes & block.InForce) == 0)
            {
                return MotionFlags.None;
            }
        }

        if ((rule.Unless & block.Maybe) != 0 || (rule.Missing & block.Given) != 0
            || (rule.Before != 0 && (rule.Before & block.Before) == 0)
            || (rule.WhileNot != 0 && ((rule.WhileNot & block.InForce) != 0 || (_table.Groups(rule.WhileNot) & block.InForce) == 0))
            || (rule.Ungiven != 0 && (rule.Ungiven & block.InForce) != 0)
            || (rule.Repeated != 0 && (rule.Repeated & control.Words.Repeated) == 0)
            || (rule.MostFunctions != int.MaxValue && control.Words.Functions.Length <= rule.MostFunctions)
            || (rule.Begins && !Begins(rule, block)))
        {
            return MotionFlags.None;
        }

        if ((rule.Where.Length > 0 && !HasOneOf(rule.Where)) || (rule.Values is { } accepted && !IsOutside(rule.Letters[0], accepted)))
        {
            return MotionFlags.None;
        }

        return Refuse(rule, block, null);
    }

    // The first of a series: the code was not in force before, and what was is known.
    private bool Begins(RefusalRule rule, in Block block)
    {
        var codes = rule.Codes[0] & block.Surely;
        return (_table.Groups(codes) & block.Before) != 0 && ((ulong)codes & block.Before) == 0;
    }

    private bool HasOneOf((byte Letter, double Value)[] words)
    {
        foreach (var (letter, value) in words)
        {
            if (control.Words.Has(letter) && control.Words.Value(letter) == value)
            {
                return true;
            }
        }

        return false;
    }

    private bool IsOutside(uint letters, RefusalValues accepted)
    {
        for (var left = letters & control.Words.Present; left != 0; left &= left - 1)
        {
            if (!accepted.Accept(control.Words.Value((byte)('A' + BitOperations.TrailingZeroCount(left)))))
            {
                return true;
            }
        }

        return false;
    }

    // How many words of the block are among some codes: one that is there twice counts twice.
    private int Count(UInt128 codes)
    {
        var count = 0;
        foreach (var code in control.Words.Codes)
        {
            count += (_table.BitOf(code) & codes) != 0 ? 1 : 0;
        }

        foreach (var function in control.Words.Functions)
        {
            count += (_table.BitOfFunction(function) & codes) != 0 ? 1 : 0;
        }

        return count;
    }

    private string Codes(UInt128 codes)
    {
        var found = new List<string>();
        foreach (var code in control.Words.Codes)
        {
            if ((_table.BitOf(code) & codes) != 0)
            {
                found.Add(string.Create(CultureInfo.InvariantCulture, $"G{code / 10m:0.#}"));
            }
        }

        foreach (var function in control.Words.Functions)
        {
            if ((_table.BitOfFunction(function) & codes) != 0)
            {
                found.Add(string.Create(CultureInfo.InvariantCulture, $"M{function}"));
            }
        }

        return string.Join(' ', found);
    }

    private static string Letters(uint letters)
    {
        var found = new List<string>();
        for (; letters != 0; letters &= letters - 1)
        {
            found.Add((letters & (0u - letters)) == RefusalTable.Polar ? "@ ^"
                : ((char)('A' + BitOperations.TrailingZeroCount(letters))).ToString());
        }

        return string.Join(' ', found);
    }

    /// <summary>Refuses a cycle that would drill upwards, if the control does.</summary>
    public MotionFlags RefuseRising(double plane, double depth) =>
        _table.Rising is { } rule && plane < depth ? Refuse(rule.Statement, "", rule.IsAssumed, isClear: false) : MotionFlags.None;

    private MotionFlags Refuse(RefusalRule rule, in Block block, string? found)
    {
        var codes = rule.Codes.Aggregate((UInt128)0, (all, set) => all | set);
        var letters = rule.Letters.Aggregate(rule.Repeated & control.Words.Repeated, (all, set) => all | set);
        found ??= string.Join(' ', ((string[])[Codes(codes), Letters(letters & block.Given)]).Where(t => t.Length > 0));
        return Refuse(rule.Statement, found, rule.IsAssumed, rule.IsClear);
    }

    private MotionFlags Refuse(string statement, string found, bool isAssumed, bool isClear)
    {
        var at = found.Length > 0 ? $" ({found})" : "";
        if (isAssumed)
        {
            control.Result.Note(MayBeRefused, $"The control may refuse this block{at}; nobody has looked it up: {statement}");
            return MotionFlags.None;
        }

        control.Result.Problem(NcRefusalCodes.RefusedByControl, $"The control refuses this block{at}: {statement}", MotionFlags.None);
        if (isClear)
        {
            return MotionFlags.None;
        }

        _stops = true;
        return MotionFlags.UnknownWord;
    }

    /// <summary>Ends a block: behind one that the control refuses, nothing is known.</summary>
    public void EndBlock()
    {
        if (_stops)
        {
            control.Layers.Forget();
        }
    }

    /// <summary>Looks at the spelling of a block that is not plain: its length and its comments.</summary>
    public void ReadSpelling(ReadOnlySpan<byte> text)
    {
        if (text.Length > control.Dialect.LongestLine)
        {
            control.Result.Problem(NcRefusalCodes.RefusedByControl, string.Create(CultureInfo.InvariantCulture,
                $"The control refuses this block: it is longer than {control.Dialect.LongestLine} characters."), MotionFlags.None);
            control.Layers.Forget();
        }

        if (control.Dialect.NestedComments != NestedComments.Accepted && HasNestedComment(text))
        {
            control.Result.Problem(NcRefusalCodes.RefusedByControl,
                "The control refuses this block: a parenthesis stands inside a comment. Write the comment without it.",
                MotionFlags.None);
            control.Layers.Forget();
        }
    }

    private bool HasNestedComment(ReadOnlySpan<byte> text)
    {
        var (isComment, isNested) = (false, false);
        foreach (var c in text)
        {
            switch (c)
            {
                case (byte)';' when !isComment:
                    return false;
                case (byte)'(' when isComment:
                    isNested = true;
                    if (control.Dialect.NestedComments == NestedComments.Refused)
                    {
                        return true;
                    }

                    break;
                case (byte)'(':
                    isComment = true;
                    break;
                case (byte)')' when isComment:
                    isComment = false;
                    break;
                case (byte)')' when isNested:
                    return true;
            }
        }

        return false;
    }
}

using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Values of the current block's words under the active modes: lengths in mm, angles in degrees, places.</summary>
internal sealed class BlockValues(NcControl control)
{
    private readonly NcDialect _dialect = control.Dialect;
    private readonly BlockWords _words = control.Words;

    /// <summary>Letters of axes that are not followed.</summary>
    public uint OtherAxes { get; } = LettersOf(control.Dialect, LetterRole.OtherAxis);

    /// <summary>Letters that the dialect does not know.</summary>
    public uint UnknownLetters { get; } = LettersOf(control.Dialect, LetterRole.Unknown);

    /// <summary>Letters that change the tool.</summary>
    public uint ToolCalls { get; } = LettersOf(control.Dialect, LetterRole.ToolCall);

    /// <summary>Letters that activate a tool length.</summary>
    public uint Lengths { get; } = LettersOf(control.Dialect, LetterRole.Length);

    /// <summary>Letters that name a tool length.</summary>
    public uint LengthNumbers { get; } = LettersOf(control.Dialect, LetterRole.LengthNumber);

    /// <summary>Letters whose number is a length.</summary>
    public uint LengthLetters { get; } =
        LettersOf(control.Dialect, LetterRole.Axis)
        | LettersOf(control.Dialect, LetterRole.Center)
        | LettersOf(control.Dialect, LetterRole.Radius);

    /// <summary>As <see cref="ControlWays.ListsIdleMoves"/> says it.</summary>
    public bool ListsIdleMoves { get; } = control.Dialect.Ways.ListsIdleMoves;

    /// <summary>Reads the words of a block that is not plain, with values computed by the flow.</summary>
    /// <param name="block">The block.</param>
    /// <param name="from">Start of its words, from its own start.</param>
    public void Read(NcBlock block, int from = 0) =>
        _words.ReadTokens(control.Run.Text.Bytes.Span, block.Start + from, block.End, _dialect.Syntax, ValueOf);

    /// <summary>Length of the corner word, as programmed.</summary>
    public double CornerLength() =>
        _words.CornerValue / (_dialect.IntegersAreIncrements && _words.CornerIsInteger ? Elementary.Pow(10, control.LeastDecimals) : 1);

    /// <summary>True if the block has a word that moves an axis in the active mode.</summary>
    public bool MovesAxes()
    {
        var given = _words.Present | _words.Computed;
        var arc = control.State.Mode is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise
            && control.State.Cycle == NcMeaning.Unknown;
        var axes = control.State.Cycle == NcMeaning.Unknown ? BlockWords.LinearAxes : BlockWords.LinearAxes | BlockWords.Bit('R');
        return (given & (axes | OtherAxes)) != 0 || _words.IsPolar || _words.HasPolarEnd || (arc && (given & BlockWords.CenterWords) != 0);
    }

    public bool StatesStraightMotion()
    {
        foreach (var code in _words.Codes)
        {
            if (_dialect.MeaningOf(code) is NcMeaning.Rapid or NcMeaning.Line)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Axes that the block names.</summary>
    public AxisSet GivenAxes() => BlockWords.AxesOf(_words.Present | _words.Computed);

    /// <summary>Axes whose words have an unknown value. If a word occurs twice, it is unknown which one applies.</summary>
    public AxisSet UnknownWords() => BlockWords.AxesOf(_words.Unknown | _words.Repeated);

    /// <summary>Letters whose words are increments, by the active mode or by their own words.</summary>
    public uint IncrementalLetters() => ((control.State.Incremental ? BlockWords.LinearAxes : 0) & ~_words.Absolute) | _words.Incremental;

    /// <summary>A place with its coordinates replaced by the block's axis words.</summary>
    public Point3 Given(Point3 place, bool incremental) => new(
        _words.Has('X') ? (incremental ? place.X : 0) + Length('X') : place.X,
        _words.Has('Y') ? (incremental ? place.Y : 0) + Length('Y') : place.Y,
        _words.Has('Z') ? (incremental ? place.Z : 0) + Length('Z') : place.Z);

    /// <summary>A word as a length in mm.</summary>
    public double Length(byte letter)
    {
        var value = _words.Value(letter);
        if (_dialect.IntegersAreIncrements && (_words.Integers & BlockWords.Bit(letter)) != 0)
        {
            value /= Elementary.Pow(10, control.LeastDecimals);
        }

        return control.State.Inch ? Sum(0, value * NcControl.MmPerInch) : value;
    }

    public double Length(char letter) => Length((byte)letter);

    /// <summary>A word as an angle in degrees. Without a decimal point it counts thousandths, or finer units if lengths do.</summary>
    public double Degrees(char letter) =>
        _words.Value(letter) / (_dialect.IntegersAreIncrements && (_words.Integers & BlockWords.Bit(letter)) != 0
            ? Elementary.Pow(10, _dialect.MetricDecimals) : 1);

    /// <summary>The place to which a block moves from another one.</summary>
    /// <param name="at">The tool's place.</param>
    /// <param name="given">Letters whose words apply.</param>
    /// <param name="incremental">Letters whose words are increments.</param>
    public Point3 End(Point3 at, uint given, uint incremental)
    {
        // In the usual case, a word is the coordinate itself.
        var isPlain = (given & incremental) == 0 && !control.State.Inch && !_dialect.IntegersAreIncrements;
        return isPlain
            ? new(PlainAxis('X', at.X, given), PlainAxis('Y', at.Y, given), PlainAxis('Z', at.Z, given))
            : new(Axis('X', at.X, given, incremental), Axis('Y', at.Y, given, incremental), Axis('Z', at.Z, given, incremental));
    }

    /// <summary>A word as a factor; without a decimal point it counts thousandths.</summary>
    public double Factor(char letter) => _words.Value(letter) / ((_words.Integers & BlockWords.Bit(letter)) != 0 ? 1000 : 1);

    /// <summary>A sum of increments, as exact as the control's: the double nearest to the decimal with ten places.</summary>
    public static double Sum(double start, double increment) => Math.Round(start + increment, 10);

    /// <summary>One value for each axis that the block names, and another for the rest.</summary>
    public Vector3 Along(Func<char, double> value, double otherwise) =>
        new(_words.Has('X') ? value('X') : otherwise, _words.Has('Y') ? value('Y') : otherwise, _words.Has('Z') ? value('Z') : otherwise);

    // Skips values of words that move nothing: tool names, angles of rotary axes, offsets.
    private double? ValueOf(NcToken token)
    {
        var role = token.Kind == NcTokenKind.PolarWord ? LetterRole.Axis : _dialect.RoleOf(token.Letter);
        var matters = role is LetterRole.Axis or LetterRole.Center or LetterRole.Radius or LetterRole.Feed or LetterRole.G or LetterRole.M
            or LetterRole.OpeningAngle or LetterRole.MoreTurns or LetterRole.IntermediatePoint
            || token.Letter is (byte)'P' or (byte)'Q' or (byte)'L' or (byte)'R' or (byte)'K';
        return matters && _dialect.HasMacros && token.ValueLength > 0
            ? control.Run.Compute(token.ValueStart, token.ValueLength)
            : double.NaN;
    }

    private double PlainAxis(char letter, double at, uint given) => (given & BlockWords.Bit(letter)) == 0 ? at : _words.Value(letter);

    private double Axis(char letter, double at, uint given, uint incremental)
    {
        var bit = BlockWords.Bit(letter);
        return (given & bit) == 0 ? at : (incremental & bit) != 0 ? Sum(at, Length(letter)) : Length(letter);
    }

    private static uint LettersOf(NcDialect dialect, LetterRole role)
    {
        var letters = 0u;
        for (var letter = 'A'; letter <= 'Z'; letter++)
        {
            letters |= dialect.RoleOf((byte)letter) == role ? BlockWords.Bit(letter) : 0;
        }

        return letters;
    }
}

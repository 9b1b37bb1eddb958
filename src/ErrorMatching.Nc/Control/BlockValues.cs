using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>What the words of a block say under the modes in force: lengths in mm, angles in degrees, places.</summary>
internal sealed class BlockValues(NcDialect dialect, ControlState control)
{
    public NcDialect Dialect => dialect;

    /// <summary>The words of the present block.</summary>
    public BlockWords Words { get; } = new();

    /// <summary>Letters of axes that are not followed.</summary>
    public uint OtherAxes { get; } = LettersOf(dialect, LetterRole.OtherAxis);

    /// <summary>Letters that the dialect does not know.</summary>
    public uint UnknownLetters { get; } = LettersOf(dialect, LetterRole.Unknown);

    /// <summary>Letters whose number is a length.</summary>
    public uint LengthLetters { get; } =
        LettersOf(dialect, LetterRole.Axis) | LettersOf(dialect, LetterRole.Center) | LettersOf(dialect, LetterRole.Radius);

    /// <summary>
    /// LinuxCNC has a motion for each step of a cycle even where it leads nowhere, and one for each block that states a straight one.
    /// </summary>
    public bool ListsIdleMoves => dialect.Syntax == NcSyntax.LinuxCnc;

    /// <summary>Length of the corner word, as programmed.</summary>
    public double CornerLength() =>
        Words.CornerValue / (Dialect.IntegersAreIncrements && Words.CornerIsInteger ? Math.Pow(10, control.LeastDecimals) : 1);

    /// <summary>True if the block has a word that moves an axis in the mode in force.</summary>
    public bool MovesAxes()
    {
        var given = Words.Present | Words.Computed;
        var arc = control.State.Mode is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise
            && control.State.Cycle == NcMeaning.Unknown;
        var axes = control.State.Cycle == NcMeaning.Unknown ? BlockWords.LinearAxes : BlockWords.LinearAxes | BlockWords.Bit('R');
        return (given & (axes | OtherAxes)) != 0 || Words.IsPolar || (arc && (given & BlockWords.CenterWords) != 0);
    }

    public bool StatesStraightMotion()
    {
        foreach (var code in Words.Codes)
        {
            if (Dialect.MeaningOf(code) is NcMeaning.Rapid or NcMeaning.Line)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Axes that the block names.</summary>
    public AxisSet GivenAxes() => BlockWords.AxesOf(Words.Present | Words.Computed);

    /// <summary>Axes of whose words the value is not known. Of a word that stands twice nobody knows which one counts.</summary>
    public AxisSet UnknownWords() => BlockWords.AxesOf(Words.Unknown | Words.Repeated);

    /// <summary>A place with the coordinates that the block's axis words give.</summary>
    public Point3 Given(Point3 place, bool incremental) => new(
        Words.Has('X') ? (incremental ? place.X : 0) + Length('X') : place.X,
        Words.Has('Y') ? (incremental ? place.Y : 0) + Length('Y') : place.Y,
        Words.Has('Z') ? (incremental ? place.Z : 0) + Length('Z') : place.Z);

    /// <summary>A word as a length in mm.</summary>
    public double Length(byte letter)
    {
        var value = Words.Value(letter);
        if (Dialect.IntegersAreIncrements && (Words.Integers & BlockWords.Bit(letter)) != 0)
        {
            value /= Math.Pow(10, control.LeastDecimals);
        }

        return control.State.Inch ? Sum(0, value * ControlState.MmPerInch) : value;
    }

    public double Length(char letter) => Length((byte)letter);

    /// <summary>A word as an angle in degrees; without a point it counts thousandths, or finer, where lengths do.</summary>
    public double Degrees(char letter) =>
        Words.Value(letter) / (Dialect.IntegersAreIncrements && (Words.Integers & BlockWords.Bit(letter)) != 0
            ? Math.Pow(10, Dialect.MetricDecimals) : 1);

    /// <summary>The place to which a block goes from another one.</summary>
    /// <param name="at">Where the tool is.</param>
    /// <param name="given">Letters whose words count.</param>
    /// <param name="incremental">Letters whose words are increments.</param>
    public Point3 End(Point3 at, uint given, uint incremental)
    {
        // Nearly always a word is the coordinate.
        var isPlain = (given & incremental) == 0 && !control.State.Inch && !Dialect.IntegersAreIncrements;
        return isPlain
            ? new(PlainAxis('X', at.X, given), PlainAxis('Y', at.Y, given), PlainAxis('Z', at.Z, given))
            : new(Axis('X', at.X, given, incremental), Axis('Y', at.Y, given, incremental), Axis('Z', at.Z, given, incremental));
    }

    /// <summary>A word as a factor; without a point it counts thousandths.</summary>
    public double Factor(char letter) => Words.Value(letter) / ((Words.Integers & BlockWords.Bit(letter)) != 0 ? 1000 : 1);

    /// <summary>Sums of increments, as exact as the control's: the double nearest to the decimal, ten digits behind the point.</summary>
    public static double Sum(double start, double increment) => Math.Round(start + increment, 10);

    /// <summary>A value for each axis that the block names, and another one for the others.</summary>
    public Vector3 Along(Func<char, double> value, double otherwise) =>
        new(Words.Has('X') ? value('X') : otherwise, Words.Has('Y') ? value('Y') : otherwise, Words.Has('Z') ? value('Z') : otherwise);

    private double PlainAxis(char letter, double at, uint given) => (given & BlockWords.Bit(letter)) == 0 ? at : Words.Value(letter);

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

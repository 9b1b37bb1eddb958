using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>The only place with lengths of what draws itself, in device-independent units of 1/96 inch,
/// and with how much of it shows through, from 0 to 1.</summary>
/// <remarks>Lengths of controls, text sizes among them, are in Sizes.axaml.</remarks>
internal static class DrawnSizes
{
    /// <summary>Thickness of rules, frames and rapids.</summary>
    public const double Thin = 1;

    /// <summary>Thickness of a cut in the path of a program.</summary>
    public const double Cut = 1.5;

    /// <summary>Thickness of what a plot is about.</summary>
    public const double Line = 2;

    /// <summary>Thickness of what stands out among lines.</summary>
    public const double Thick = 3;

    /// <summary>Thickness of the stroke that closes what would be seen between two neighbors of a map.</summary>
    public const double Hairline = 0.6;

    /// <summary>Half of a thin line: so far from a border it lies on whole pixels.</summary>
    public const double HalfThin = 0.5;

    /// <summary>Height of the shade at an edge beyond which there is more.</summary>
    public const double EdgeShade = 14;

    /// <summary>Radius of a point.</summary>
    public const double Dot = 4;

    /// <summary>The least radius of a point among many.</summary>
    public const double LeastDot = 0.5;

    /// <summary>Radius of the ring around a place that was asked for, or where something begins.</summary>
    public const double Ring = 7;

    /// <summary>Half of a mark on a line of values.</summary>
    public const double Mark = 5;

    /// <summary>The same where marks stand close together.</summary>
    public const double LeastMark = 1.5;

    /// <summary>How much further the corners of a diamond reach than a circle that looks as large.</summary>
    public const double DiamondMore = 1;

    /// <summary>How much further the ring around a value outside of its limits reaches than its mark.</summary>
    public const double OutsideMore = 4;

    /// <summary>How far apart places are at least for rings: closer ones would be a stripe.</summary>
    public const double OutsideApart = 4;

    /// <summary>Half of a mark that others stand out from.</summary>
    public const double QuietMark = 3.5;

    /// <summary>Half of a mark of a second figure.</summary>
    public const double MeanMark = 2;

    /// <summary>How far a label is from what it belongs to.</summary>
    public const double LabelAway = 8;

    /// <summary>How far a number of a map stands above its point.</summary>
    public const double NumberAbove = 5;

    /// <summary>Room within a box around words, and between a sign and its name.</summary>
    public const double Around = 8;

    /// <summary>Room between a line and words along it.</summary>
    public const double Near = 6;

    /// <summary>How much further than words their ground reaches on each side.</summary>
    public const double VeilBeside = 2;

    /// <summary>Radius of the corners of that ground.</summary>
    public const double VeilRound = 3;

    /// <summary>How much of that ground is seen: what lies behind shows through, so that it can be followed.</summary>
    public const double VeilOpacity = 0.85;

    /// <summary>The same on a map, where what lies behind is a color that means something.</summary>
    public const double MapVeilOpacity = 0.65;

    /// <summary>How much is seen of the lines of a net behind what is drawn.</summary>
    public const double RuleOpacity = 0.35;

    /// <summary>How much is seen of a line around colors.</summary>
    public const double FrameOpacity = 0.4;

    /// <summary>Width of the numbers beside a plot over a series.</summary>
    public const double LeftStrip = 62;

    /// <summary>Height of the names below it.</summary>
    public const double BottomStrip = 30;

    /// <summary>The least distance between two lines of its net.</summary>
    public const double TicksApart = 30;

    /// <summary>The least distance between two of the names below it.</summary>
    public const double LabelsApart = 14;

    /// <summary>Length of a line in a legend.</summary>
    public const double LegendMark = 34;

    /// <summary>Distance between two lines of a legend, each with its name.</summary>
    public const double LegendApart = 24;

    /// <summary>Height of a bar of colors.</summary>
    public const double ColorBar = 18;

    /// <summary>Length of a tick below it.</summary>
    public const double Tick = 4;

    /// <summary>How much two neighbors of it lie over each other.</summary>
    public const double Overlap = 0.5;

    /// <summary>How far lines go on beyond the border, so that their ends and joins are not seen.</summary>
    public const double Beyond = 16;

    /// <summary>What a finger does before it drags.</summary>
    public const double FingerStill = 8;

    /// <summary>Half of what a finger covers.</summary>
    public const double FingerReach = 28;

    /// <summary>Width of the bar beside chosen lines of a program.</summary>
    public const double TextBar = 4;

    /// <summary>Width of the bar beside the lines of a feature.</summary>
    public const double FeatureBar = 2;

    /// <summary>Room between the columns of a program.</summary>
    public const double TextApart = 6;

    /// <summary>The least width over which a finger drags along the lines of a program: 15 mm, as a target in Sizes.axaml.</summary>
    public const double LeastGutter = 57;

    /// <summary>Length of a dash of a rapid, and of what is not drawn between two of them,
    /// in pixels where it is drawn pixel by pixel.</summary>
    public const int RapidDash = 6, RapidGap = 4;

    /// <summary>How far the box of values is from its place, the nearest that is free.</summary>
    public static IReadOnlyList<double> BoxAway { get; } = [12, 30, 60, 100];

    /// <summary>A line that is dashed, in multiples of its thickness.</summary>
    public static DashStyle Dashes { get; } = new([4, 3], 0);

    /// <summary>A rapid, in multiples of its thickness.</summary>
    public static DashStyle RapidDashes { get; } = new([RapidDash, RapidGap], 0);
}

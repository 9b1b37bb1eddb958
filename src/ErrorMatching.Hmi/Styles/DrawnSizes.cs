using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>The only place for lengths in custom drawing, in device-independent units of 1/96 inch, and for opacities from 0 to
/// 1.</summary>
/// <remarks>Lengths of controls, including text sizes, are in Sizes.axaml.</remarks>
internal static class DrawnSizes
{
    /// <summary>Thickness of rules, frames and rapids.</summary>
    public const double Thin = 1;

    /// <summary>Thickness of a cut in a program's path.</summary>
    public const double Cut = 1.5;

    /// <summary>Thickness of the main lines of a plot.</summary>
    public const double Line = 2;

    /// <summary>Thickness of highlighted lines.</summary>
    public const double Thick = 3;

    /// <summary>Half of a thin line, the offset from a border that aligns it to whole pixels.</summary>
    public const double HalfThin = 0.5;

    /// <summary>Height of the shade at an edge with more content beyond it.</summary>
    public const double EdgeShade = 14;

    /// <summary>Radius of a point.</summary>
    public const double Dot = 4;

    /// <summary>Smallest radius of a point among many.</summary>
    public const double LeastDot = 0.5;

    /// <summary>Radius of the ring around a requested place or a start.</summary>
    public const double Ring = 7;

    /// <summary>Half the size of a mark on a line of values.</summary>
    public const double Mark = 5;

    /// <summary>The same for closely spaced marks.</summary>
    public const double LeastMark = 1.5;

    /// <summary>Additional extent of a diamond's corners compared with a circle that looks as large.</summary>
    public const double DiamondMore = 1;

    /// <summary>Additional radius of the ring around a value outside its limits, compared with its mark.</summary>
    public const double OutsideMore = 4;

    /// <summary>Smallest distance between rings; closer ones would merge into a stripe.</summary>
    public const double OutsideApart = 4;

    /// <summary>Half the size of an unobtrusive mark.</summary>
    public const double QuietMark = 3.5;

    /// <summary>Half the size of a mark of a second value.</summary>
    public const double MeanMark = 2;

    /// <summary>Distance of a label from its object.</summary>
    public const double LabelAway = 8;

    /// <summary>Distance of a section's letter from the end of its line.</summary>
    public const double LettersAway = 14;

    /// <summary>Smallest distance of two passes of a tool over a map: the colors stay visible between them.</summary>
    public const double PassesApart = 8;

    /// <summary>Length of the axes beside a turned surface.</summary>
    public const double Axis = 34;

    /// <summary>Height of a map number above its point.</summary>
    public const double NumberAbove = 5;

    /// <summary>Padding of a text box, and gap between a sign and its name.</summary>
    public const double Around = 8;

    /// <summary>Gap between a line and the text along it.</summary>
    public const double Near = 6;

    /// <summary>A plot that is less wide has its buttons in one column.</summary>
    public const double NarrowPlot = 480;

    /// <summary>Horizontal padding of a text's background on each side.</summary>
    public const double VeilBeside = 2;

    /// <summary>Corner radius of that background.</summary>
    public const double VeilRound = 3;

    /// <summary>Opacity of that background; what is behind shows through, so that the eye can follow it.</summary>
    public const double VeilOpacity = 0.85;

    /// <summary>The same on a map, whose colors have a meaning.</summary>
    public const double MapVeilOpacity = 0.65;

    /// <summary>Opacity of grid lines behind the drawing.</summary>
    public const double RuleOpacity = 0.35;

    /// <summary>Opacity of the mesh on a turned surface.</summary>
    public const double MeshOpacity = 0.3;

    /// <summary>Opacity of a frame around colors.</summary>
    public const double FrameOpacity = 0.4;

    /// <summary>Width of the numbers to the left of a series plot.</summary>
    public const double LeftStrip = 62;

    /// <summary>Height of the names below it.</summary>
    public const double BottomStrip = 30;

    /// <summary>Smallest distance between two of its grid lines.</summary>
    public const double TicksApart = 30;

    /// <summary>Smallest distance between two of the names below it.</summary>
    public const double LabelsApart = 14;

    /// <summary>Length of a line in a legend.</summary>
    public const double LegendMark = 34;

    /// <summary>Distance between two legend lines with their names.</summary>
    public const double LegendApart = 24;

    /// <summary>Height of a color bar.</summary>
    public const double ColorBar = 18;

    /// <summary>Length of a tick below it.</summary>
    public const double Tick = 4;

    /// <summary>Overlap of two neighbors in it.</summary>
    public const double Overlap = 0.5;

    /// <summary>Extension of lines beyond the border, which hides their ends and joins.</summary>
    public const double Beyond = 16;

    /// <summary>Movement of a finger before a drag starts.</summary>
    public const double FingerStill = 8;

    /// <summary>Half the width that a finger covers.</summary>
    public const double FingerReach = 28;

    /// <summary>Width of the bar next to selected program lines.</summary>
    public const double TextBar = 4;

    /// <summary>Width of the bar next to the lines of a feature.</summary>
    public const double FeatureBar = 2;

    /// <summary>Gap between the columns of a program.</summary>
    public const double TextApart = 6;

    /// <summary>Smallest width for dragging along program lines: 15 mm, like a target in Sizes.axaml.</summary>
    public const double LeastGutter = 57;

    /// <summary>Length of a rapid's dashes and gaps, in pixels if drawn pixel by pixel.</summary>
    public const int RapidDash = 6, RapidGap = 4;

    /// <summary>Distances of the value box from its place; the nearest free one is used.</summary>
    public static IReadOnlyList<double> BoxAway { get; } = [12, 30, 60, 100];

    /// <summary>Dash pattern of a line, in multiples of its thickness.</summary>
    public static DashStyle Dashes { get; } = new([4, 3], 0);

    /// <summary>Dash pattern of a rapid, in multiples of its thickness.</summary>
    public static DashStyle RapidDashes { get; } = new([RapidDash, RapidGap], 0);
}

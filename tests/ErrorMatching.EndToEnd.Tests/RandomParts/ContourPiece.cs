namespace ErrorMatching.EndToEnd.Tests;

/// <summary>An element in its contour: to which feature it belongs, which group of key points it carries (-1: none), and how much of its
/// boundary the corners take away.</summary>
internal sealed record ContourPiece(IPathElement Element, int Feature, int Group, double TrimIn, double TrimOut)
{
    /// <summary>An element that no feature owns.</summary>
    public const int Connector = -1;

    /// <summary>A key point stays this far from an element's ends, mm, so that a displaced neighbor does not reach it.</summary>
    public const double Margin = 1.5;

    /// <summary>
    /// Length of boundary that a corner takes: where the path turns left by an angle, toward the material,
    /// both walls end in a sharp edge before the path's vertex.
    /// </summary>
    public static double Trim(double turn, double offset) => turn > 0 ? offset * Math.Tan(turn / 2) : 0;

    /// <summary>Angle between -pi and pi.</summary>
    public static double Wrap(double angle) => Math.IEEERemainder(angle, 2 * Math.PI);
}

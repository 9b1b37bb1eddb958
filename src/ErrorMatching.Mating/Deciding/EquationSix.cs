using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Equation (6) of Wang 2021, literally. It reproduces the paper's tables; do not use it to make programs.</summary>
/// <remarks>The equation, X2 = X1 - dX - dia/2 with dX = counterpart - part, gives the converted columns of tables 6 and 7, which are 2 *
/// part - counterpart in X without the tool radius. It assumes a counterpart that was cut for the actual part; for one cut with the
/// nominal program it would apply the part's deviation twice. It also subtracts the tool radius from both coordinates, which is right
/// only where the boundary's normal is (-1, -1). Programs are displaced along normals instead (<see cref="Decider"/>).</remarks>
public static class EquationSix
{
    /// <summary>The corrected coordinates of the counterpart.</summary>
    /// <param name="part">The actual point of the part.</param>
    /// <param name="counterpart">The measured point of the counterpart.</param>
    /// <param name="toolDiameterMm">Half of this diameter is subtracted from both coordinates; 0 gives tables 6 and 7.</param>
    public static Point2 Corrected(Point2 part, Point2 counterpart, double toolDiameterMm = 0)
    {
        var radius = toolDiameterMm / 2;
        return part - (counterpart - part) - new Vector2(radius, radius);
    }
}

using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>
/// Equation (6) of Wang 2021 to the letter. It reproduces the paper's tables; it is not a way to make programs.
/// </summary>
/// <remarks>
/// The equation, X2 = X1 - dX - dia/2 with dX = counterpart - part, makes the converted columns of tables 6 and 7, which are 2 * part -
/// counterpart in X, the tool's radius left out. It presumes a counterpart that was cut for the actual part: of one cut with the nominal
/// program it would count the part's deviation twice. And it takes the tool's radius off both coordinates, which is right only where the
/// normal of the boundary is (-1, -1). Programs are displaced along normals instead (<see cref="Decider"/>).
/// </remarks>
public static class EquationSix
{
    /// <summary>The corrected coordinates of the counterpart.</summary>
    /// <param name="part">The actual point of the part.</param>
    /// <param name="counterpart">The measured point of the counterpart.</param>
    /// <param name="toolDiameterMm">The diameter whose half is taken off both coordinates; 0 makes tables 6 and 7.</param>
    public static Point2 Corrected(Point2 part, Point2 counterpart, double toolDiameterMm = 0)
    {
        var radius = toolDiameterMm / 2;
        return part - (counterpart - part) - new Vector2(radius, radius);
    }
}

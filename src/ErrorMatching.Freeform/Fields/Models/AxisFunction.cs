namespace ErrorMatching.Freeform;

/// <summary>One function of the hierarchical basis on an axis from -1 to 1: a Chebyshev polynomial, or a one-sided power <c>((t - xi)+ /
/// (1 - xi))^p</c> beyond a break.</summary>
/// <param name="Power">Degree.</param>
/// <param name="Break">The break xi; null for a polynomial on the whole axis.</param>
internal sealed record AxisFunction(int Power, double? Break = null)
{
    public double At(double t)
    {
        if (Break is { } xi)
        {
            return t <= xi ? 0 : Pow((t - xi) / (1 - xi), Power);
        }

        var (previous, current) = (1.0, t);
        for (var k = 1; k < Power; k++)
        {
            (previous, current) = (current, (2 * t * current) - previous);
        }

        return Power == 0 ? 1 : current;
    }

    /// <summary>The basis functions of an axis. The square of a break follows the square of the whole axis, its cube the cube.</summary>
    public static AxisFunction[] Hierarchy(int degree, IReadOnlyList<double> breaks) =>
        [
            .. Enumerable.Range(0, degree + 1).Select(p => new AxisFunction(p)),
            .. breaks.SelectMany(xi => new AxisFunction[] { new(2, xi), new(3, xi) })];

    /// <summary>The previous function in the hierarchy, which a term requires; null for the constant.</summary>
    public AxisFunction? Parent => (Power, Break) switch
    {
        (0, _) => null,
        (2, not null) => new(1),
        _ => new(Power - 1, Break),
    };

    private static double Pow(double x, int power)
    {
        var result = x;
        for (var k = 1; k < power; k++)
        {
            result *= x;
        }

        return result;
    }
}

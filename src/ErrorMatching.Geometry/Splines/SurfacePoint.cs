namespace ErrorMatching.Geometry;

/// <summary>A point on a surface with its derivatives, from which normals and curvatures follow. Lengths in millimeters.</summary>
/// <param name="U">First parameter.</param>
/// <param name="V">Second parameter.</param>
/// <param name="Position">The point.</param>
/// <param name="Du">First derivative with respect to u.</param>
/// <param name="Dv">First derivative with respect to v.</param>
/// <param name="Duu">Second derivative with respect to u.</param>
/// <param name="Duv">Mixed second derivative.</param>
/// <param name="Dvv">Second derivative with respect to v.</param>
public readonly record struct SurfacePoint(
    double U, double V, Point3 Position, Vector3 Du, Vector3 Dv, Vector3 Duu, Vector3 Duv, Vector3 Dvv)
{
    /// <summary>Unit normal Du x Dv; zero if the surface has none (a pole, a fold).</summary>
    public Vector3 Normal
    {
        get
        {
            var cross = Du.Cross(Dv);
            var length = cross.Length;
            return length > 0 ? cross * (1 / length) : Vector3.Zero;
        }
    }

    /// <summary>Mean of the two principal curvatures in 1/mm, positive if the surface bends towards its normal (do Carmo, Differential
    /// Geometry of Curves and Surfaces, section 3.3).</summary>
    public double MeanCurvature => Curvatures().Mean;

    /// <summary>Product of the two principal curvatures in 1/mm^2.</summary>
    public double GaussianCurvature => Curvatures().Gaussian;

    /// <summary>The two principal curvatures in 1/mm, the larger one first, positive if the surface bends towards its normal.</summary>
    public (double Largest, double Smallest) PrincipalCurvatures
    {
        get
        {
            var (mean, gaussian) = Curvatures();
            var root = Math.Sqrt(Math.Max(0, (mean * mean) - gaussian));
            return (mean + root, mean - root);
        }
    }

    /// <summary>Curvature of the normal section in the direction a Du + b Dv, in 1/mm, positive if it bends towards the normal.</summary>
    public double NormalCurvature(double a, double b)
    {
        var normal = Normal;
        var second = (a * a * Duu.Dot(normal)) + (2 * a * b * Duv.Dot(normal)) + (b * b * Dvv.Dot(normal));
        return second / ((a * a * Du.Dot(Du)) + (2 * a * b * Du.Dot(Dv)) + (b * b * Dv.Dot(Dv)));
    }

    private (double Mean, double Gaussian) Curvatures()
    {
        var normal = Normal;
        var (e, f, g) = (Du.Dot(Du), Du.Dot(Dv), Dv.Dot(Dv));
        var (l, m, n) = (Duu.Dot(normal), Duv.Dot(normal), Dvv.Dot(normal));
        var area = (e * g) - (f * f);
        return (((e * n) - (2 * f * m) + (g * l)) / (2 * area), ((l * n) - (m * m)) / area);
    }
}

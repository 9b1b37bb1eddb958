namespace ErrorMatching.Freeform;

/// <summary>The names of error field models in reports.</summary>
internal static class FieldWords
{
    /// <summary>The identifier in JSON documents.</summary>
    public static string Of(FieldModelKind kind) => kind switch
    {
        FieldModelKind.Polynomial => "polynomial",
        FieldModelKind.GaussianProcess => "gaussian-process",
        FieldModelKind.Interpolant => "interpolating-spline",
        _ => "cubic-spline",
    };

    /// <summary>A sentence for HTML reports.</summary>
    public static string Sentence(FieldModelKind kind) => kind switch
    {
        FieldModelKind.Polynomial => "A polynomial of few terms, in pieces where the curvature breaks.",
        FieldModelKind.GaussianProcess => "A Gaussian process: smooth waves of a length that the points tell.",
        FieldModelKind.Interpolant => "A cubic spline through every point: what smoother models left of them was no noise.",
        _ => "A cubic spline.",
    };
}

using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>What reports call the models of an error field.</summary>
internal static class FieldWords
{
    /// <summary>The word in JSON documents.</summary>
    public static string Of(FieldModelKind kind) => kind switch
    {
        FieldModelKind.Polynomial => "polynomial",
        FieldModelKind.GaussianProcess => "gaussian-process",
        _ => "cubic-spline",
    };

    /// <summary>A probability behind the letter p: one that is too small for four digits is said to be smaller than they show.</summary>
    public static string Probability(double p) => p < 0.0001 ? "< 0.0001" : p.ToString("0.####", CultureInfo.InvariantCulture);

    /// <summary>A sentence for people.</summary>
    public static string Sentence(FieldModelKind kind) => kind switch
    {
        FieldModelKind.Polynomial => "A polynomial of few terms, in pieces where the curvature breaks.",
        FieldModelKind.GaussianProcess => "A Gaussian process: smooth waves of a length that the points tell.",
        _ => "A cubic spline.",
    };
}

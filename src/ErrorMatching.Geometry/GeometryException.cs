namespace ErrorMatching.Geometry;

/// <summary>A geometric question without a usable answer, named by its <see cref="Error"/>.</summary>
public sealed class GeometryException : Exception
{
    /// <summary>An error with the reason in words.</summary>
    /// <param name="error">What is wrong.</param>
    /// <param name="message">What was found and what is expected, in a metrologist's words.</param>
    public GeometryException(GeometryError error, string message)
        : base(message) => Error = error;

    /// <summary>What is wrong.</summary>
    public GeometryError Error { get; }
}

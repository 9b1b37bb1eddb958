namespace ErrorMatching.Geometry;

/// <summary>A geometric calculation without a usable result.</summary>
public sealed class GeometryException : Exception
{
    /// <summary>Creates an exception.</summary>
    /// <param name="error">The kind of error.</param>
    /// <param name="message">The finding and the expectation, in a metrologist's words.</param>
    public GeometryException(GeometryError error, string message)
        : base(message) => Error = error;

    /// <summary>The kind of error.</summary>
    public GeometryError Error { get; }
}

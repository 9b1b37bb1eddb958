namespace ErrorMatching.Geometry.Tests;

/// <summary>Asserts on named refusals.</summary>
internal static class Refused
{
    public static GeometryException With(GeometryError error, Func<object?> question)
    {
        var refusal = Assert.Throws<GeometryException>(question);
        Assert.Equal(error, refusal.Error);
        return refusal;
    }
}

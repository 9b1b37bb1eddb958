using System.Text.Json;
using ErrorMatching.Geometry;

namespace ErrorMatching.Console;

/// <summary>Number formats for every JSON document of the console: zero has no minus sign.</summary>
internal static class JsonNumbers
{
    /// <summary>Writes a number with as many digits as distinguish it from its neighbors; null for NaN, which JSON lacks.</summary>
    public static void Number(this Utf8JsonWriter json, string name, double value)
    {
        if (double.IsFinite(value))
        {
            json.WriteNumber(name, value + 0.0);
        }
        else
        {
            json.WriteNull(name);
        }
    }

    /// <summary>Writes an array of numbers.</summary>
    public static void Numbers(this Utf8JsonWriter json, string name, IEnumerable<double> values)
    {
        json.WriteStartArray(name);
        foreach (var value in values)
        {
            json.WriteNumberValue(value + 0.0);
        }

        json.WriteEndArray();
    }

    /// <summary>Writes a pair of coordinates as <c>{ "x", "y" }</c>.</summary>
    public static void Pair(this Utf8JsonWriter json, string name, double x, double y)
    {
        json.WriteStartObject(name);
        json.Number("x", x);
        json.Number("y", y);
        json.WriteEndObject();
    }

    /// <summary>Writes a point as <c>{ "x", "y" }</c>.</summary>
    public static void Point(this Utf8JsonWriter json, string name, Point2 point) => json.Pair(name, point.X, point.Y);
}

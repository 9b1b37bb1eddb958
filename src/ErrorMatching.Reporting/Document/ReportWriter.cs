using System.Text.Encodings.Web;
using System.Text.Json;
using ErrorMatching.Geometry;

namespace ErrorMatching.Reporting;

/// <summary>Writes report values as JSON: camelCase, millimeters and degrees, numbers without the noise of binary fractions.</summary>
/// <param name="json">The output.</param>
public sealed class ReportWriter(Utf8JsonWriter json)
{
    // A picometer is far below the resolution of any gauge, and far above the rounding errors of the calculation.
    private const int Decimals = 9;

    /// <summary>Creates an indented document with the same line ends on every system.</summary>
    /// <param name="schema">Name of its schema.</param>
    /// <param name="content">Writes its members.</param>
    /// <param name="encoder">What it escapes; null for everything that is not safe in a web page.</param>
    public static byte[] Document(string schema, Action<ReportWriter> content, JavaScriptEncoder? encoder = null)
    {
        using var buffer = new MemoryStream();
        using (var json = new Utf8JsonWriter(buffer, new JsonWriterOptions { Indented = true, NewLine = "\n", Encoder = encoder }))
        {
            json.WriteStartObject();
            json.WriteString("schema", schema);
            content(new(json));
            json.WriteEndObject();
        }

        buffer.WriteByte((byte)'\n');
        return buffer.ToArray();
    }

    /// <summary>Writes the job of the report.</summary>
    /// <param name="kind">The kind of job: <c>mating</c> or <c>freeform</c>.</param>
    /// <param name="job">The job.</param>
    public void Job(string kind, ReportJob job) => Object("job", () =>
    {
        Text("kind", kind);
        Text("name", job.Name);
        Text("workOrder", job.WorkOrder);
        Text("file", job.File);
        Text("sha256", job.Sha256);
    });

    /// <summary>Writes the input files of the report.</summary>
    public void Inputs(IReadOnlyList<ReportInput> inputs) => List("inputs", inputs, i =>
    {
        Text("role", i.Role);
        Text("file", i.File);
        Text("sha256", i.Sha256);
    });

    /// <summary>Writes warnings as sentences, and separately their codes and values.</summary>
    public void Warnings(IReadOnlyList<ReportWarning> warnings)
    {
        ArgumentNullException.ThrowIfNull(warnings);
        Texts("warnings", warnings.Select(w => w.Message));
        List("warningCodes", warnings, w =>
        {
            Text("code", w.Code);
            Texts("values", w.Values);
        });
    }

    /// <summary>Writes a text or null.</summary>
    public void Text(string name, string? value) => json.WriteString(name, value);

    /// <summary>Writes a Boolean, or null.</summary>
    public void Flag(string name, bool? value)
    {
        if (value is { } flag)
        {
            json.WriteBoolean(name, flag);
        }
        else
        {
            json.WriteNull(name);
        }
    }

    /// <summary>Writes a count.</summary>
    public void Count(string name, int value) => json.WriteNumber(name, value);

    /// <summary>Writes a number of millimeters or degrees, or null.</summary>
    public void Number(string name, double? value)
    {
        if (value is { } v)
        {
            json.WriteNumber(name, Clean(v));
        }
        else
        {
            json.WriteNull(name);
        }
    }

    /// <summary>Writes a dimensionless number, which may be small but significant.</summary>
    public void Exact(string name, double value) => json.WriteNumber(name, value);

    /// <summary>Writes a list of dimensionless numbers.</summary>
    public void Numbers(string name, IEnumerable<double> values)
    {
        json.WriteStartArray(name);
        foreach (var value in values)
        {
            json.WriteNumberValue(Clean(value));
        }

        json.WriteEndArray();
    }

    /// <summary>Writes a list of texts.</summary>
    public void Texts(string name, IEnumerable<string> values)
    {
        json.WriteStartArray(name);
        foreach (var value in values)
        {
            json.WriteStringValue(value);
        }

        json.WriteEndArray();
    }

    /// <summary>Writes an object.</summary>
    public void Object(string name, Action content)
    {
        json.WriteStartObject(name);
        content();
        json.WriteEndObject();
    }

    /// <summary>Writes an object, or null if there is no value.</summary>
    public void Optional<T>(string name, T? value, Action<T> content)
        where T : class
    {
        if (value is null)
        {
            json.WriteNull(name);
        }
        else
        {
            Object(name, () => content(value));
        }
    }

    /// <summary>Writes a list of objects.</summary>
    public void List<T>(string name, IEnumerable<T> items, Action<T> content)
    {
        json.WriteStartArray(name);
        foreach (var item in items)
        {
            json.WriteStartObject();
            content(item);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    /// <summary>Writes a point in the plane as an object with x and y.</summary>
    public void Point(string name, Point2 point) => Vector(name, point - Point2.Origin);

    /// <summary>Writes a vector in the plane as an object with x and y.</summary>
    public void Vector(string name, Vector2 vector) => Object(name, () => Vector(vector));

    /// <summary>Writes the members x and y of a vector into the open object.</summary>
    public void Vector(Vector2 vector)
    {
        Number("x", vector.X);
        Number("y", vector.Y);
    }

    /// <summary>Writes a list of points.</summary>
    public void Points(string name, IEnumerable<Point2> points) => List(name, points, p => Vector(p - Point2.Origin));

    // Adding zero turns -0 into 0.
    private static double Clean(double value) => Math.Round(value, Decimals) + 0.0;
}

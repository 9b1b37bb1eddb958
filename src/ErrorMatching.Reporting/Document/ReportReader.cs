using System.Globalization;
using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Reporting;

/// <summary>Reads an object of a stored report: the counterpart of <see cref="ReportWriter"/>. Members that it does not ask for are
/// ignored, so that a report with more of them can be read.</summary>
/// <remarks>A member that is missing or wrong is a <see cref="InputException"/> with its path, line and column. Members that older
/// reports lack are read as optional ones.</remarks>
public sealed class ReportReader
{
    // Written by this system for programs of any length, so nothing but memory limits it.
    private static readonly JsonLimits Limits = new(int.MaxValue, JsonLimits.Default.MaxDepth, int.MaxValue);

    private readonly JsonItem _item;
    private readonly string _file;

    private ReportReader(JsonItem item, string file) => (_item, _file) = (item, file);

    /// <summary>The schema of the document, such as <c>errormatch/match/1</c>.</summary>
    public string Schema => Text("schema");

    /// <summary>The names of the object's members.</summary>
    public IReadOnlyList<string> Names => [.. _item.Members.Select(m => m.Name)];

    /// <summary>Reads a document.</summary>
    /// <param name="json">UTF-8 text.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="InputException">It is not JSON, or not an object.</exception>
    public static ReportReader Document(ReadOnlySpan<byte> json, string file = "report.json")
    {
        var reader = new ReportReader(JsonInput.Read(json, file, Limits), file);
        return reader._item.Kind == JsonItemKind.Object ? reader : throw reader.Refusal(reader._item, "wrong-type", "an object");
    }

    /// <summary>Reads one object of a document and skips the rest, which takes a small part of the time of reading all.</summary>
    /// <param name="json">UTF-8 text.</param>
    /// <param name="name">A member of the document.</param>
    /// <returns>Null if the document has no such member, or another value there.</returns>
    /// <exception cref="JsonException">What stands before the end of the object is not JSON.</exception>
    public static ReportReader? ObjectOf(ReadOnlySpan<byte> json, string name)
    {
        var tokens = new Utf8JsonReader(json);
        if (!tokens.Read() || tokens.TokenType != JsonTokenType.StartObject) return null;
        while (tokens.Read() && tokens.TokenType == JsonTokenType.PropertyName)
        {
            var isIt = tokens.ValueTextEquals(name);
            tokens.Read();
            var start = (int)tokens.TokenStartIndex;
            tokens.Skip();
            if (!isIt) continue;
            var value = json[start..(int)tokens.BytesConsumed];
            return value[0] == (byte)'{' ? Document(value) : null;
        }

        return null;
    }

    /// <summary>Refuses a member, or the object if it does not have that member.</summary>
    /// <param name="name">The member.</param>
    /// <param name="code">A stable code.</param>
    /// <param name="expected">What is expected instead.</param>
    public InputException Refusal(string name, string code, string expected) => Refusal(_item.Find(name) ?? _item, code, expected);

    /// <summary>Reads an object.</summary>
    public ReportReader Object(string name) => new(Member(name, JsonItemKind.Object, "an object"), _file);

    /// <summary>Reads an object; null if it is missing or null.</summary>
    public ReportReader? OptionalObject(string name) => Has(name) ? Object(name) : null;

    /// <summary>Reads a text.</summary>
    public string Text(string name) => Member(name, JsonItemKind.Text, "text").Text;

    /// <summary>Reads a text; null if it is missing or null.</summary>
    public string? OptionalText(string name) => Has(name) ? Text(name) : null;

    /// <summary>Reads a Boolean.</summary>
    public bool Flag(string name) => Member(name, JsonItemKind.Boolean, "true or false").Flag;

    /// <summary>Reads a Boolean; null if it is missing or null.</summary>
    public bool? OptionalFlag(string name) => Has(name) ? Flag(name) : null;

    /// <summary>Reads a count.</summary>
    public int Count(string name) => Whole(Member(name, JsonItemKind.Number, "a number"));

    /// <summary>Reads a number.</summary>
    public double Number(string name) => Member(name, JsonItemKind.Number, "a number").Number;

    /// <summary>Reads a number; null if it is missing or null.</summary>
    public double? OptionalNumber(string name) => Has(name) ? Number(name) : null;

    /// <summary>Reads a length in micrometers as millimeters.</summary>
    public double Micrometers(string name) => Number(name) / 1000;

    /// <summary>Reads one of several values by its word.</summary>
    /// <param name="name">The member.</param>
    /// <param name="all">The values.</param>
    /// <param name="word">The word of a value.</param>
    public T Word<T>(string name, IReadOnlyList<T> all, Func<T, string> word)
    {
        ArgumentNullException.ThrowIfNull(all);
        var text = Text(name);
        foreach (var value in all)
        {
            if (word(value) == text)
            {
                return value;
            }
        }

        throw Refusal(name, "not-one-of", string.Join(" or ", all.Select(v => $"\"{word(v)}\"")));
    }

    /// <summary>Reads a value of an enumeration by its word.</summary>
    public T Word<T>(string name, Func<T, string> word)
        where T : struct, Enum => Word(name, Enum.GetValues<T>(), word);

    /// <summary>Reads a list of objects.</summary>
    public IReadOnlyList<T> List<T>(string name, Func<ReportReader, T> read) =>
        [.. Each(name, JsonItemKind.Object, "an object", i => read(new(i, _file)))];

    /// <summary>Reads a list of objects; empty if it is missing or null.</summary>
    public IReadOnlyList<T> OptionalList<T>(string name, Func<ReportReader, T> read) => Has(name) ? List(name, read) : [];

    /// <summary>Reads a list of texts.</summary>
    public IReadOnlyList<string> Texts(string name) => [.. Each(name, JsonItemKind.Text, "text", i => i.Text)];

    /// <summary>Reads a list of texts; empty if it is missing or null.</summary>
    public IReadOnlyList<string> OptionalTexts(string name) => Has(name) ? Texts(name) : [];

    /// <summary>Reads a list of numbers.</summary>
    /// <param name="name">The member.</param>
    /// <param name="count">How many there must be; null for any number of them.</param>
    public IReadOnlyList<double> Numbers(string name, long? count = null)
    {
        double[] numbers = [.. Each(name, JsonItemKind.Number, "a number", i => i.Number)];
        return count is { } n && numbers.Length != n
            ? throw Refusal(
                name,
                numbers.Length < n ? "too-few-items" : "too-many-items",
                string.Create(CultureInfo.InvariantCulture, $"a list of {n}"))
            : numbers;
    }

    /// <summary>Reads a list of numbers; null if it is missing or null.</summary>
    /// <param name="name">The member.</param>
    /// <param name="count">How many there must be.</param>
    public IReadOnlyList<double>? OptionalNumbers(string name, long count) => Has(name) ? Numbers(name, count) : null;

    /// <summary>Reads a list of numbers, or a word in place of it.</summary>
    /// <param name="name">The member.</param>
    /// <param name="count">How many numbers there must be.</param>
    /// <param name="word">The word.</param>
    /// <returns>The numbers; null for the word.</returns>
    public IReadOnlyList<double>? NumbersOrWord(string name, long count, string word) =>
        _item.Find(name) is not { Kind: JsonItemKind.Text } text ? Numbers(name, count)
            : text.Text == word ? null
            : throw Refusal(name, "not-one-of", $"a list of numbers or \"{word}\"");

    /// <summary>Reads a list of counts.</summary>
    public IReadOnlyList<int> Counts(string name) => [.. Each(name, JsonItemKind.Number, "a number", Whole)];

    /// <summary>Reads a list of names, which may be written as texts or as counts.</summary>
    public IReadOnlyList<string> Labels(string name) =>
        Member(name, JsonItemKind.List, "a list").Items is [{ Kind: JsonItemKind.Number }, ..]
            ? [.. Counts(name).Select(c => c.ToString(CultureInfo.InvariantCulture))]
            : Texts(name);

    /// <summary>Reads a point in the plane.</summary>
    public Point2 Point(string name) => Point2.Origin + Vector(name);

    /// <summary>Reads a point in the plane; null if it is missing or null.</summary>
    public Point2? OptionalPoint(string name) => Has(name) ? Point(name) : null;

    /// <summary>Reads a vector in the plane.</summary>
    public Vector2 Vector(string name) => Object(name).Vector();

    /// <summary>Reads the members x and y of a vector.</summary>
    public Vector2 Vector() => new(Number("x"), Number("y"));

    /// <summary>Reads a list of points in the plane.</summary>
    public IReadOnlyList<Point2> Points(string name) => List(name, p => Point2.Origin + p.Vector());

    /// <summary>Reads a point in space, a list of three numbers.</summary>
    public Point3 Point3(string name) => default(Point3) + Vector3(name);

    /// <summary>Reads a vector in space, a list of three numbers.</summary>
    public Vector3 Vector3(string name)
    {
        var coordinates = Numbers(name, 3);
        return new(coordinates[0], coordinates[1], coordinates[2]);
    }

    /// <summary>Reads the job of the report.</summary>
    public ReportJob Job()
    {
        var job = Object("job");
        return new(job.Text("name"), job.OptionalText("workOrder"), job.Text("file"), job.Text("sha256"));
    }

    /// <summary>Reads the input files of the report.</summary>
    public IReadOnlyList<ReportInput> Inputs() => List("inputs", i => new ReportInput(i.Text("role"), i.Text("file"), i.Text("sha256")));

    /// <summary>Reads warnings. In reports older than the codes of warnings, they have none.</summary>
    public IReadOnlyList<ReportWarning> Warnings()
    {
        var codes = OptionalList("warningCodes", c => (Code: c.Text("code"), Values: c.Texts("values")));
        return [
            .. Texts("warnings").Select((message, i) => i < codes.Count
                ? new ReportWarning(codes[i].Code, message, codes[i].Values)
                : new ReportWarning("", message, []))];
    }

    private bool Has(string name) => _item.Find(name) is { Kind: not JsonItemKind.Null };

    private JsonItem Member(string name, JsonItemKind kind, string expected) =>
        _item.Find(name) is not { } member
            ? throw new InputException(_file, [JsonRefusal.At(_item, "missing-key", $"no key \"{name}\"", $"the key \"{name}\"")])
            : Checked(member, kind, expected);

    private IEnumerable<T> Each<T>(string name, JsonItemKind kind, string expected, Func<JsonItem, T> read) =>
        Member(name, JsonItemKind.List, "a list").Items.Select(i => read(Checked(i, kind, expected)));

    private JsonItem Checked(JsonItem item, JsonItemKind kind, string expected) =>
        item.Kind == kind ? item : throw Refusal(item, "wrong-type", expected);

    private int Whole(JsonItem item) => item.Number is >= 0 and <= int.MaxValue && Math.Floor(item.Number) == item.Number
        ? (int)item.Number
        : throw Refusal(item, "wrong-type", "a count");

    private InputException Refusal(JsonItem item, string code, string expected) =>
        new(_file, [JsonRefusal.At(item, code, item.ToString(), expected)]);
}

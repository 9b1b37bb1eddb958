using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The attributes of one type in a STEP instance, accessed by index. Every error names the instance and line.</summary>
/// <param name="File">The file.</param>
/// <param name="Id">Number of the instance.</param>
/// <param name="Line">Line where it starts.</param>
/// <param name="Keyword">The type.</param>
/// <param name="Values">The attributes.</param>
internal sealed record StepRecord(StepFile File, long Id, int Line, string Keyword, IReadOnlyList<StepValue> Values)
{
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"#{Id} {Keyword}");

    public double Real(int index) => Of(index, StepValueKind.Number, "a number").Number;

    /// <summary>Reads an integer within limits.</summary>
    public int Int(int index, int least, int most)
    {
        var number = Real(index);
        return number >= least && number <= most && number == Math.Floor(number)
            ? (int)number
            : throw Fail(
                "bad-value",
                string.Create(
                    CultureInfo.InvariantCulture, $"{number} as attribute {index + 1}; a whole number from {least} to {most} is expected"));
    }

    /// <summary>Reads a string; empty if omitted.</summary>
    public string Text(int index) => At(index).Kind == StepValueKind.Omitted ? "" : Of(index, StepValueKind.Text, "a string").Text;

    /// <summary>Reads a word between periods.</summary>
    public string Word(int index) =>
        At(index).Kind == StepValueKind.Omitted ? "" : Of(index, StepValueKind.Word, "a word between points").Text;

    public bool Flag(int index) => Word(index) switch
    {
        "T" => true,
        "F" => false,
        var other => throw Fail("bad-value", $"{ExchangeLimits.Quote(other)} as attribute {index + 1}; .T. or .F. is expected"),
    };

    public IReadOnlyList<StepValue> List(int index) => Of(index, StepValueKind.List, "a list").Items;

    public double[] Reals(int index) => Reals(List(index), index);

    /// <summary>Reads the numbers of a list nested in an attribute.</summary>
    public double[] Reals(IReadOnlyList<StepValue> list, int index)
    {
        var numbers = new double[list.Count];
        for (var i = 0; i < numbers.Length; i++)
        {
            numbers[i] = list[i].Kind == StepValueKind.Number
                ? list[i].Number
                : throw Fail("bad-value", $"attribute {index + 1} has an item that is no number; numbers are expected");
        }

        return numbers;
    }

    public IEnumerable<StepInstance> Instances(int index) => List(index).Select(v => Instance(v, index));

    public StepInstance Instance(int index) => Instance(At(index), index);

    /// <summary>The instance that an element of an attribute refers to.</summary>
    public StepInstance Instance(StepValue value, int index) => value.Kind == StepValueKind.Reference
        ? File.At((long)value.Number)
            ?? throw Fail(
                "bad-reference",
                string.Create(
                    CultureInfo.InvariantCulture, $"attribute {index + 1} refers to #{(long)value.Number}, which the file does not have"))
        : throw Fail("bad-value", $"attribute {index + 1} is no reference; one (#...) is expected");

    /// <summary>The attributes of the type that an attribute must refer to.</summary>
    public StepRecord Record(int index, string keyword)
    {
        var instance = Instance(index);
        return instance.Find(keyword) ?? throw Fail("bad-reference", $"attribute {index + 1} refers to {instance}; {keyword} is expected");
    }

    /// <summary>Reads the coordinates of a CARTESIAN_POINT or DIRECTION.</summary>
    /// <param name="value">The reference.</param>
    /// <param name="index">Index of the attribute that contains the reference.</param>
    /// <param name="keyword">CARTESIAN_POINT or DIRECTION.</param>
    public Vector3 Coordinates(StepValue value, int index, string keyword)
    {
        var instance = Instance(value, index);
        var record = instance.Find(keyword)
            ?? throw Fail("bad-reference", $"attribute {index + 1} refers to {instance}; {keyword} is expected");
        var numbers = record.Reals(1);
        return numbers.Length is 2 or 3
            ? new(numbers[0], numbers[1], numbers.Length == 3 ? numbers[2] : 0)
            : throw record.Fail("bad-value", $"{numbers.Length} coordinates; 2 or 3 are expected");
    }

    public StepValue At(int index) =>
        index >= 0 && index < Values.Count
            ? Values[index]
            : throw Fail("bad-value", $"it has {Values.Count} attributes; more are expected");

    public InputException Fail(string code, string problem) => InputException.At(code, File.Name, $"{this}: {problem}", Line);

    private StepValue Of(int index, StepValueKind kind, string expected) => At(index) is var value && value.Kind == kind ? value
        : value.Kind == StepValueKind.Typed && value.Items.Count == 1 && value.Items[0].Kind == kind ? value.Items[0]
        : throw Fail("bad-value", $"attribute {index + 1} is not {expected}");
}

using System.Globalization;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>Writes an outcome: one JSON document to the output, or text to the output and errors to standard error.</summary>
internal static class OutcomeWriter
{
    private const string ErrorSchema = "errormatch/error/1";

    // Names of files and features are not escaped: the document is UTF-8 and is not embedded in a web page.
    private static readonly JsonWriterOptions Options = new()
    {
        Indented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping
    };

    public static ExitCode Write(VerbResult outcome, Terminal terminal, bool isJson)
    {
        switch (outcome)
        {
            case Answer answer when isJson:
                answer.WriteJson(terminal.Output);
                break;
            case Answer { Program: { } program } answer:
                using (var output = terminal.ProgramOutput())
                {
                    output.Write(program.Span);
                }

                answer.WriteText(new Page(terminal.Error, terminal.HasErrorColor));
                break;
            case Answer answer:
                answer.WriteText(new Page(terminal.Output, terminal.HasColor));
                WriteErrors(terminal, answer.Failure);
                break;
            case Failure { Exit: not ExitCode.Cancelled } failure when isJson:
                terminal.Output.Write(Encoding.UTF8.GetString(Json(ErrorSchema, json => WriteErrors(json, failure))));
                break;
            case Failure failure:
                WriteErrors(terminal, failure);
                break;
        }

        return (outcome as Failure ?? (outcome as Answer)?.Failure)?.Exit ?? ExitCode.Done;
    }

    /// <summary>A JSON document: UTF-8 without a byte order mark, with a final line end.</summary>
    public static byte[] Json(string schema, Action<Utf8JsonWriter> write)
    {
        using var stream = new MemoryStream();
        Json(stream, schema, write);
        return stream.ToArray();
    }

    /// <summary>Writes such a document to a stream. A long one flushes its writer in parts.</summary>
    public static void Json(Stream stream, string schema, Action<Utf8JsonWriter> write)
    {
        using (var json = new Utf8JsonWriter(stream, Options))
        {
            json.WriteStartObject();
            json.WriteString("schema", schema);
            write(json);
            json.WriteEndObject();
        }

        stream.WriteByte((byte)'\n');
    }

    private static void WriteErrors(Terminal terminal, Failure? failure)
    {
        foreach (var error in failure?.Errors ?? [])
        {
            new Page(terminal.Error, terminal.HasErrorColor).Error(PrintedText.OneLine(Line(error)));
        }
    }

    /// <summary>A document with <c>exit</c> and <c>errors</c> after its schema, if its result must not be used.</summary>
    /// <param name="document">The document.</param>
    /// <param name="failure">Why not; null if it may be used.</param>
    public static byte[] WithErrors(byte[] document, Failure? failure)
    {
        if (failure is null)
        {
            return document;
        }

        using var parsed = JsonDocument.Parse(document);
        var root = parsed.RootElement;
        return Json(root.GetProperty("schema").GetString()!, json =>
        {
            WriteErrors(json, failure);
            foreach (var member in root.EnumerateObject().Skip(1))
            {
                member.WriteTo(json);
            }
        });
    }

    /// <summary>Writes the members <c>exit</c> and <c>errors</c>.</summary>
    public static void WriteErrors(Utf8JsonWriter json, Failure failure)
    {
        json.WriteNumber("exit", (int)failure.Exit);
        json.WriteStartArray("errors");
        foreach (var error in failure.Errors)
        {
            Write(json, error);
        }

        json.WriteEndArray();
    }

    /// <summary>Writes one item with the members that apply to it.</summary>
    public static void Write(Utf8JsonWriter json, Refusal item)
    {
        json.WriteStartObject();
        json.WriteString("code", item.Code);
        json.WriteString("message", item.Sentence);
        WriteText(json, "file", item.Place.File);
        WriteNumber(json, "line", item.Place.Line);
        WriteNumber(json, "column", item.Place.Column);
        WriteText(json, "path", item.Place.Path);
        WriteText(json, "block", item.Place.Block);
        json.WriteEndObject();
    }

    private static void WriteText(Utf8JsonWriter json, string name, string? value)
    {
        if (value is not null)
        {
            json.WriteString(name, value);
        }
    }

    private static void WriteNumber(Utf8JsonWriter json, string name, int? value)
    {
        if (value is { } number)
        {
            json.WriteNumber(name, number);
        }
    }

    // file:line:column: the form that editors and build logs recognize.
    private static string Line(Refusal error)
    {
        var place = error.Place;
        if (error.NamesFile || (place.File ?? place.Path) is not { } at)
        {
            return "errormatch: " + error.Message;
        }

        var line = new StringBuilder(at);
        foreach (var number in new[] { place.Line, place.Column })
        {
            line.Append(number is null ? "" : string.Create(CultureInfo.InvariantCulture, $":{number}"));
        }

        line.Append(place.File is null || place.Path is null ? "" : ":" + place.Path).Append(": ");

        // A block without a number is named by its line, which the place in front has already.
        var name = place.Line is { } first ? string.Create(CultureInfo.InvariantCulture, $"line {first}: ") : "";
        var start = error.Message.StartsWith(name, StringComparison.Ordinal) ? name.Length : 0;
        return line.Append(error.Message.AsSpan(start)).ToString();
    }
}

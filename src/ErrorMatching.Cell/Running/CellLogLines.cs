using System.Globalization;
using ErrorMatching.Jobs;
using Serilog.Events;
using Serilog.Formatting;
using Serilog.Formatting.Display;

namespace ErrorMatching.Cell;

/// <summary>The log for people: time, level and message on one line each, whatever characters a file name contains.</summary>
internal sealed class CellLogLines : ITextFormatter
{
    private readonly MessageTemplateTextFormatter _line = new("{Timestamp:HH:mm:ss} {Level:w3} {Message:l}", CultureInfo.InvariantCulture);

    public void Format(LogEvent logEvent, TextWriter output)
    {
        using var line = new StringWriter(CultureInfo.InvariantCulture);
        _line.Format(logEvent, line);
        output.Write(PrintedText.OneLine(line.ToString()) + "\n");
        if (logEvent.Exception is { } defect)
        {
            output.Write(defect + "\n");
        }
    }
}

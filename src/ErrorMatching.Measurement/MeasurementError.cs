using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>The codes of <see cref="InputException"/>: stable identifiers for scripts. Codes may be added but never change.</summary>
public static class MeasurementError
{
    /// <summary>The file cannot be opened: it is missing, or the user has no read permission.</summary>
    public const string FileUnreadable = "file-unreadable";

    /// <summary>The file has no bytes, or only blank lines.</summary>
    public const string EmptyFile = "empty-file";

    /// <summary>The file has more bytes than the format allows.</summary>
    public const string FileTooLarge = "file-too-large";

    /// <summary>The file has more points than the format allows.</summary>
    public const string TooManyPoints = "too-many-points";

    /// <summary>A line has more cells than allowed, or the file has more lines or cells than any measurement.</summary>
    public const string TooManyCells = "too-many-cells";

    /// <summary>The file contains NUL bytes or other control characters: it is not text.</summary>
    public const string BinaryFile = "binary-file";

    /// <summary>Bytes that are invalid in the format's encoding, or the byte order mark of another encoding.</summary>
    public const string InvalidEncoding = "invalid-encoding";

    /// <summary>The closing quotation mark of a cell is missing.</summary>
    public const string UnclosedQuote = "unclosed-quote";

    /// <summary>A quotation mark inside an unquoted cell, or text after a closing one.</summary>
    public const string BadQuote = "bad-quote";

    /// <summary>The file has no header line.</summary>
    public const string MissingHeader = "missing-header";

    /// <summary>The header lacks a required column.</summary>
    public const string MissingColumn = "missing-column";

    /// <summary>The header names a required column twice.</summary>
    public const string DuplicateColumn = "duplicate-column";

    /// <summary>A line has fewer cells than the header.</summary>
    public const string ShortRow = "short-row";

    /// <summary>A line has more cells than the header, and these are not empty.</summary>
    public const string LongRow = "long-row";

    /// <summary>A required cell is empty.</summary>
    public const string EmptyCell = "empty-cell";

    /// <summary>A cell contains NaN.</summary>
    public const string NotANumber = "not-a-number";

    /// <summary>A cell contains an infinity.</summary>
    public const string InfiniteNumber = "infinite-number";

    /// <summary>A cell contains text instead of a number.</summary>
    public const string TextForNumber = "text-for-number";

    /// <summary>A cell contains a spreadsheet formula.</summary>
    public const string Formula = "formula";

    /// <summary>A number contains thousands separators.</summary>
    public const string ThousandsSeparator = "thousands-separator";

    /// <summary>A decimal comma, but the format specifies a point.</summary>
    public const string DecimalComma = "decimal-comma";

    /// <summary>A decimal point, but the format specifies a comma.</summary>
    public const string DecimalPoint = "decimal-point";

    /// <summary>A number too large or too small for double precision.</summary>
    public const string NumberOutOfRange = "number-out-of-range";

    /// <summary>A coordinate beyond a kilometer: a lost decimal point or a wrong unit.</summary>
    public const string ImplausibleNumber = "implausible-number";

    /// <summary>Two lines give the same point, or the same coordinate of a feature.</summary>
    public const string DuplicatePoint = "duplicate-point";

    /// <summary>A required point is missing in the file.</summary>
    public const string MissingPoint = "missing-point";

    /// <summary>The file has a header but no points.</summary>
    public const string NoPoints = "no-points";

    /// <summary>A feature has some coordinates but lacks X or Y.</summary>
    public const string MissingCoordinate = "missing-coordinate";

    /// <summary>A deviation is not actual - nominal.</summary>
    public const string InconsistentDeviation = "inconsistent-deviation";

    /// <summary>A file of a format that describes itself (QIF, AQDEF, DMIS, CALYPSO, PC-DMIS) is cut off or violates the format.</summary>
    public const string BadStructure = "bad-structure";

    /// <summary>A probing move that ended without a contact.</summary>
    public const string MissedTouch = "missed-touch";

    /// <summary>A log without labels has another number of points than the job or the plan.</summary>
    public const string PointCount = "point-count";

    /// <summary>A rule of the job that maps labels is wrong, or two of its points get the same label.</summary>
    public const string BadLabels = "bad-labels";

    /// <summary>The file is something else, such as a surface, a mesh, a job or a program.</summary>
    public const string NotAMeasurement = "not-a-measurement";

    /// <summary>The file contains measurements of several pieces.</summary>
    public const string SeveralMeasurements = "several-measurements";

    /// <summary>The file's unit is neither millimeters nor inches, or it does not name one that it must name.</summary>
    public const string UnknownUnit = "unknown-unit";

    /// <summary>Values (.dfx) without the file that describes them (.dfd).</summary>
    public const string MissingDescription = "missing-description";

    /// <summary>A document of another version than the supported one.</summary>
    public const string UnsupportedVersion = "unsupported-version";

    /// <summary>The description of a format is wrong, or its name is unknown.</summary>
    public const string BadFormat = "bad-format";

    /// <summary>A range of labels is wrong.</summary>
    public const string BadRange = "bad-range";

    /// <summary>A rule's pattern is not a supported regular expression, or takes too long.</summary>
    public const string BadPattern = "bad-pattern";

    /// <summary>No rule determines whether the file belongs to the part or the counterpart.</summary>
    public const string UndecidedSource = "undecided-source";

    /// <summary>Rules of the part and of the counterpart match the same file.</summary>
    public const string ContradictorySource = "contradictory-source";
}

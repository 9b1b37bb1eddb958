namespace ErrorMatching.Measurement;

/// <summary>The codes of <see cref="MeasurementException"/>: stable words that scripts may compare. New ones may be added; none changes its meaning.</summary>
public static class MeasurementError
{
    /// <summary>The file cannot be opened: it is missing, or this user may not read it.</summary>
    public const string FileUnreadable = "file-unreadable";

    /// <summary>The file has no bytes, or nothing but blank lines.</summary>
    public const string EmptyFile = "empty-file";

    /// <summary>The file has more bytes than the format allows.</summary>
    public const string FileTooLarge = "file-too-large";

    /// <summary>The file has more points than the format allows.</summary>
    public const string TooManyPoints = "too-many-points";

    /// <summary>A line has more cells than a table may have columns, or the file has more lines or cells than any measurement.</summary>
    public const string TooManyCells = "too-many-cells";

    /// <summary>The file holds NUL bytes or other control characters: it is not text.</summary>
    public const string BinaryFile = "binary-file";

    /// <summary>Bytes that are no character in the format's encoding, or the byte order mark of another encoding.</summary>
    public const string InvalidEncoding = "invalid-encoding";

    /// <summary>A quotation mark opens a cell and no other closes it.</summary>
    public const string UnclosedQuote = "unclosed-quote";

    /// <summary>A quotation mark stands inside a cell that is not quoted, or text stands behind a closing one.</summary>
    public const string BadQuote = "bad-quote";

    /// <summary>The file has no header line.</summary>
    public const string MissingHeader = "missing-header";

    /// <summary>The header lacks a column that is needed.</summary>
    public const string MissingColumn = "missing-column";

    /// <summary>The header names a needed column twice.</summary>
    public const string DuplicateColumn = "duplicate-column";

    /// <summary>A line has fewer cells than the header.</summary>
    public const string ShortRow = "short-row";

    /// <summary>A line has more cells than the header, and they are not empty.</summary>
    public const string LongRow = "long-row";

    /// <summary>A cell that must hold something is empty.</summary>
    public const string EmptyCell = "empty-cell";

    /// <summary>A cell holds NaN.</summary>
    public const string NotANumber = "not-a-number";

    /// <summary>A cell holds an infinity.</summary>
    public const string InfiniteNumber = "infinite-number";

    /// <summary>A cell holds text where a number belongs.</summary>
    public const string TextForNumber = "text-for-number";

    /// <summary>A cell holds a spreadsheet formula.</summary>
    public const string Formula = "formula";

    /// <summary>A number is written with separators between its thousands.</summary>
    public const string ThousandsSeparator = "thousands-separator";

    /// <summary>A decimal comma where the format says point.</summary>
    public const string DecimalComma = "decimal-comma";

    /// <summary>A decimal point where the format says comma.</summary>
    public const string DecimalPoint = "decimal-point";

    /// <summary>A number too large or too small for double precision.</summary>
    public const string NumberOutOfRange = "number-out-of-range";

    /// <summary>A coordinate beyond a kilometer: a lost decimal point or a wrong unit.</summary>
    public const string ImplausibleNumber = "implausible-number";

    /// <summary>Two lines give the same point, or the same coordinate of a feature.</summary>
    public const string DuplicatePoint = "duplicate-point";

    /// <summary>A point that is asked for is not in the file.</summary>
    public const string MissingPoint = "missing-point";

    /// <summary>The file has a header and no points.</summary>
    public const string NoPoints = "no-points";

    /// <summary>A feature has some of its coordinates but lacks X or Y.</summary>
    public const string MissingCoordinate = "missing-coordinate";

    /// <summary>A deviation is not actual - nominal.</summary>
    public const string InconsistentDeviation = "inconsistent-deviation";

    /// <summary>The description of a format is wrong, or no format has the name.</summary>
    public const string BadFormat = "bad-format";

    /// <summary>A range of labels is wrong.</summary>
    public const string BadRange = "bad-range";

    /// <summary>A rule's pattern is no regular expression, or one that takes too long.</summary>
    public const string BadPattern = "bad-pattern";

    /// <summary>No rule tells whether the file is the part's or the counterpart's.</summary>
    public const string UndecidedSource = "undecided-source";

    /// <summary>Rules of the part and of the counterpart match the same file.</summary>
    public const string ContradictorySource = "contradictory-source";
}

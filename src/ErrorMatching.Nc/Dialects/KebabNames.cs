using System.Text;

namespace ErrorMatching.Nc;

/// <summary>The values of enumerations by their names in files: <c>WorkOffset</c> is <c>work-offset</c>, <c>PlaneXY</c> is
/// <c>plane-xy</c>.</summary>
internal static class KebabNames
{
    /// <summary>The values of a byte enumeration by name. Plain numbers, because the runtime has such tables precompiled and every start
    /// needs this.</summary>
    public static Dictionary<string, int> Of(Type enumeration)
    {
        var (names, values) = (enumeration.GetEnumNames(), (byte[])enumeration.GetEnumValuesAsUnderlyingType());
        var table = new Dictionary<string, int>(names.Length, StringComparer.Ordinal);
        for (var i = 0; i < names.Length; i++)
        {
            table.Add(Of(names[i]), values[i]);
        }

        return table;
    }

    /// <summary>A name as spelled in files.</summary>
    public static string Of(string name)
    {
        var text = new StringBuilder(name.Length + 8);
        for (var i = 0; i < name.Length; i++)
        {
            if (i > 0 && char.IsAsciiLetterUpper(name[i]) && !char.IsAsciiLetterUpper(name[i - 1]))
            {
                text.Append('-');
            }

            text.Append(char.ToLowerInvariant(name[i]));
        }

        return text.ToString();
    }
}

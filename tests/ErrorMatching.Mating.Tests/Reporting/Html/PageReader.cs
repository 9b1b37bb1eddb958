using System.Text;
using System.Xml.Linq;

namespace ErrorMatching.Mating.Tests;

/// <summary>Reads a page back as XML, which fails if an element is left open or a character is not escaped.</summary>
internal static class PageReader
{
    public static XElement Read(byte[] page) => XDocument.Parse(Encoding.UTF8.GetString(page), LoadOptions.PreserveWhitespace).Root!;

    public static XElement ById(this XElement page, string id) => page.Descendants().Single(e => (string?)e.Attribute("id") == id);

    /// <summary>The table with a caption of that identifier.</summary>
    public static XElement Table(this XElement page, string captionId) => page.ById(captionId).Parent!;

    /// <summary>The texts of the cells of a row that is named by its head.</summary>
    public static string Row(this XElement table, string head) =>
        string.Join('|', table.Element("tbody")!.Elements("tr").First(r => r.Element("th")!.Value == head).Elements().Select(c => c.Value));

    public static bool HasClass(this XElement element, string name) =>
        ((string?)element.Attribute("class") ?? "").Split(' ').Contains(name);

    public static IEnumerable<XElement> WithClass(this XElement page, string element, string name) =>
        page.Descendants(element).Where(e => e.HasClass(name));
}

using System.Xml;
using System.Xml.Linq;
using System.Xml.Schema;

namespace ErrorMatching.Measurement.Tests;

/// <summary>What QIF 3.0 demands of the part of a document that results of points use: elements, their order and counts, attributes,
/// identifiers and references. Written by us from the published schema and its samples.</summary>
internal static class QifSchema
{
    private const string Text = """
        <xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema" xmlns="http://qifstandards.org/xsd/qif3" xmlns:t="http://qifstandards.org/xsd/qif3"
          targetNamespace="http://qifstandards.org/xsd/qif3" elementFormDefault="qualified">
          <xs:simpleType name="Id"><xs:restriction base="xs:unsignedInt"><xs:minInclusive value="1"/></xs:restriction></xs:simpleType>
          <xs:simpleType name="Uuid"><xs:restriction base="xs:string"><xs:pattern value="[0-9a-fA-F]{8}(-[0-9a-fA-F]{4}){3}-[0-9a-fA-F]{12}"/></xs:restriction></xs:simpleType>
          <xs:simpleType name="Doubles"><xs:list itemType="xs:double"/></xs:simpleType>
          <xs:simpleType name="Triple"><xs:restriction base="Doubles"><xs:length value="3"/></xs:restriction></xs:simpleType>
          <xs:simpleType name="Status"><xs:restriction base="xs:string"><xs:enumeration value="PASS"/><xs:enumeration value="FAIL"/><xs:enumeration value="UNKNOWN"/></xs:restriction></xs:simpleType>
          <xs:complexType name="Empty"/>
          <xs:complexType name="Definition"><xs:attribute name="id" type="Id" use="required"/></xs:complexType>
          <xs:complexType name="Ids"><xs:sequence><xs:element name="Id" type="Id" maxOccurs="unbounded"/></xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType>
          <xs:element name="QIFDocument">
            <xs:complexType>
              <xs:sequence>
                <xs:element name="QPId" type="Uuid"/>
                <xs:element name="Header">
                  <xs:complexType><xs:sequence>
                    <xs:element name="Application"><xs:complexType><xs:sequence><xs:element name="Name" type="xs:string"/></xs:sequence></xs:complexType></xs:element>
                    <xs:element name="Description" type="xs:string"/>
                    <xs:element name="Scope" type="xs:string"/>
                  </xs:sequence></xs:complexType>
                </xs:element>
                <xs:element name="StandardsDefinitions" minOccurs="0">
                  <xs:complexType>
                    <xs:sequence>
                      <xs:element name="Standard" maxOccurs="unbounded">
                        <xs:complexType>
                          <xs:sequence>
                            <xs:element name="Organization"><xs:complexType><xs:sequence><xs:element name="StandardsOrganizationEnum" fixed="ISO"/></xs:sequence></xs:complexType></xs:element>
                            <xs:element name="Designator" type="xs:string"/>
                            <xs:element name="Year" type="xs:gYear"/>
                          </xs:sequence>
                          <xs:attribute name="id" type="Id" use="required"/>
                        </xs:complexType>
                      </xs:element>
                    </xs:sequence>
                    <xs:attribute name="n" type="Id" use="required"/>
                  </xs:complexType>
                </xs:element>
                <xs:element name="FileUnits">
                  <xs:complexType><xs:sequence><xs:element name="PrimaryUnits"><xs:complexType><xs:sequence><xs:element name="LinearUnit"><xs:complexType><xs:sequence>
                    <xs:element name="SIUnitName" fixed="meter"/>
                    <xs:element name="UnitName" type="xs:string"/>
                    <xs:element name="UnitConversion"><xs:complexType><xs:sequence><xs:element name="Factor" type="xs:double"/></xs:sequence></xs:complexType></xs:element>
                  </xs:sequence></xs:complexType></xs:element></xs:sequence></xs:complexType></xs:element></xs:sequence></xs:complexType>
                </xs:element>
                <xs:element name="DatumReferenceFrames" minOccurs="0">
                  <xs:complexType><xs:sequence><xs:element name="DatumReferenceFrame" type="Definition" maxOccurs="unbounded"/></xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType>
                </xs:element>
                <xs:element name="Features">
                  <xs:complexType><xs:sequence>
                    <xs:element name="FeatureDefinitions">
                      <xs:complexType><xs:sequence><xs:element name="PointFeatureDefinition" type="Definition" maxOccurs="unbounded"/></xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType>
                    </xs:element>
                    <xs:element name="FeatureNominals">
                      <xs:complexType><xs:sequence>
                        <xs:element name="PointFeatureNominal" maxOccurs="unbounded">
                          <xs:complexType><xs:sequence>
                            <xs:element name="FeatureDefinitionId" type="Id"/><xs:element name="Location" type="Triple"/><xs:element name="Normal" type="Triple"/>
                          </xs:sequence><xs:attribute name="id" type="Id" use="required"/></xs:complexType>
                        </xs:element>
                      </xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType>
                    </xs:element>
                    <xs:element name="FeatureItems">
                      <xs:complexType><xs:sequence>
                        <xs:element name="PointFeatureItem" maxOccurs="unbounded">
                          <xs:complexType><xs:sequence>
                            <xs:element name="FeatureNominalId" type="Id"/>
                            <xs:element name="FeatureName" type="xs:string"/>
                            <xs:element name="DeterminationMode"><xs:complexType><xs:sequence><xs:element name="Checked"><xs:complexType><xs:sequence>
                              <xs:element name="CheckDetails"><xs:complexType><xs:sequence><xs:element name="Measured" type="Empty"/></xs:sequence></xs:complexType></xs:element>
                            </xs:sequence></xs:complexType></xs:element></xs:sequence></xs:complexType></xs:element>
                          </xs:sequence><xs:attribute name="id" type="Id" use="required"/></xs:complexType>
                        </xs:element>
                      </xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType>
                    </xs:element>
                  </xs:sequence></xs:complexType>
                </xs:element>
                <xs:element name="Characteristics" minOccurs="0">
                  <xs:complexType><xs:sequence>
                    <xs:element name="FormalStandardId" type="Id"/>
                    <xs:element name="CharacteristicDefinitions">
                      <xs:complexType><xs:sequence>
                        <xs:element name="PointProfileCharacteristicDefinition" maxOccurs="unbounded">
                          <xs:complexType><xs:sequence>
                            <xs:element name="ToleranceValue"><xs:simpleType><xs:restriction base="xs:double"><xs:minInclusive value="0"/></xs:restriction></xs:simpleType></xs:element>
                            <xs:element name="OuterDisposition" type="xs:double" minOccurs="0"/>
                            <xs:element name="DatumReferenceFrameId" type="Id"/>
                          </xs:sequence><xs:attribute name="id" type="Id" use="required"/></xs:complexType>
                        </xs:element>
                      </xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType>
                    </xs:element>
                    <xs:element name="CharacteristicNominals">
                      <xs:complexType><xs:sequence>
                        <xs:element name="PointProfileCharacteristicNominal" maxOccurs="unbounded">
                          <xs:complexType><xs:sequence><xs:element name="CharacteristicDefinitionId" type="Id"/></xs:sequence><xs:attribute name="id" type="Id" use="required"/></xs:complexType>
                        </xs:element>
                      </xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType>
                    </xs:element>
                    <xs:element name="CharacteristicItems">
                      <xs:complexType><xs:sequence>
                        <xs:element name="PointProfileCharacteristicItem" maxOccurs="unbounded">
                          <xs:complexType><xs:sequence>
                            <xs:element name="Name" type="xs:string"/><xs:element name="FeatureItemIds" type="Ids"/><xs:element name="CharacteristicNominalId" type="Id"/>
                          </xs:sequence><xs:attribute name="id" type="Id" use="required"/></xs:complexType>
                        </xs:element>
                      </xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType>
                    </xs:element>
                  </xs:sequence></xs:complexType>
                </xs:element>
                <xs:element name="Results">
                  <xs:complexType><xs:sequence><xs:element name="MeasurementResultsSet"><xs:complexType><xs:sequence>
                    <xs:element name="MeasurementResults">
                      <xs:complexType>
                        <xs:sequence>
                          <xs:element name="MeasuredFeatures">
                            <xs:complexType><xs:sequence>
                              <xs:element name="PointFeatureMeasurement" maxOccurs="unbounded">
                                <xs:complexType><xs:sequence><xs:element name="FeatureItemId" type="Id"/><xs:element name="Location" type="Triple"/></xs:sequence><xs:attribute name="id" type="Id" use="required"/></xs:complexType>
                              </xs:element>
                            </xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType>
                          </xs:element>
                          <xs:element name="MeasuredCharacteristics" minOccurs="0">
                            <xs:complexType><xs:sequence><xs:element name="CharacteristicMeasurements"><xs:complexType><xs:sequence>
                              <xs:element name="PointProfileCharacteristicMeasurement" maxOccurs="unbounded">
                                <xs:complexType><xs:sequence>
                                  <xs:element name="Status"><xs:complexType><xs:sequence><xs:element name="CharacteristicStatusEnum" type="Status"/></xs:sequence></xs:complexType></xs:element>
                                  <xs:element name="CharacteristicItemId" type="Id"/><xs:element name="FeatureMeasurementIds" type="Ids"/><xs:element name="Value" type="xs:double"/>
                                </xs:sequence><xs:attribute name="id" type="Id" use="required"/></xs:complexType>
                              </xs:element>
                            </xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType></xs:element></xs:sequence></xs:complexType>
                          </xs:element>
                          <xs:element name="InspectionStatus"><xs:complexType><xs:sequence><xs:element name="InspectionStatusEnum" type="Status"/></xs:sequence></xs:complexType></xs:element>
                        </xs:sequence>
                        <xs:attribute name="id" type="Id" use="required"/>
                      </xs:complexType>
                    </xs:element>
                  </xs:sequence><xs:attribute name="n" type="Id" use="required"/></xs:complexType></xs:element></xs:sequence></xs:complexType>
                </xs:element>
              </xs:sequence>
              <xs:attribute name="versionQIF" fixed="3.0.0" use="required"/>
              <xs:attribute name="idMax" type="Id" use="required"/>
            </xs:complexType>
            <xs:unique name="Ids"><xs:selector xpath=".//t:*"/><xs:field xpath="@id"/></xs:unique>
            <xs:key name="Standards"><xs:selector xpath="t:StandardsDefinitions/t:Standard"/><xs:field xpath="@id"/></xs:key>
            <xs:keyref name="StandardRef" refer="Standards"><xs:selector xpath="t:Characteristics/t:FormalStandardId"/><xs:field xpath="."/></xs:keyref>
            <xs:key name="Frames"><xs:selector xpath="t:DatumReferenceFrames/t:DatumReferenceFrame"/><xs:field xpath="@id"/></xs:key>
            <xs:keyref name="FrameRef" refer="Frames"><xs:selector xpath=".//t:DatumReferenceFrameId"/><xs:field xpath="."/></xs:keyref>
            <xs:key name="FeatureDefinitionKey"><xs:selector xpath="t:Features/t:FeatureDefinitions/t:*"/><xs:field xpath="@id"/></xs:key>
            <xs:keyref name="FeatureDefinitionRef" refer="FeatureDefinitionKey"><xs:selector xpath=".//t:FeatureDefinitionId"/><xs:field xpath="."/></xs:keyref>
            <xs:key name="FeatureNominalKey"><xs:selector xpath="t:Features/t:FeatureNominals/t:*"/><xs:field xpath="@id"/></xs:key>
            <xs:keyref name="FeatureNominalRef" refer="FeatureNominalKey"><xs:selector xpath=".//t:FeatureNominalId"/><xs:field xpath="."/></xs:keyref>
            <xs:key name="FeatureItemKey"><xs:selector xpath="t:Features/t:FeatureItems/t:*"/><xs:field xpath="@id"/></xs:key>
            <xs:keyref name="FeatureItemRef" refer="FeatureItemKey"><xs:selector xpath=".//t:FeatureItemId | .//t:FeatureItemIds/t:Id"/><xs:field xpath="."/></xs:keyref>
            <xs:key name="CharacteristicDefinitionKey"><xs:selector xpath="t:Characteristics/t:CharacteristicDefinitions/t:*"/><xs:field xpath="@id"/></xs:key>
            <xs:keyref name="CharacteristicDefinitionRef" refer="CharacteristicDefinitionKey"><xs:selector xpath=".//t:CharacteristicDefinitionId"/><xs:field xpath="."/></xs:keyref>
            <xs:key name="CharacteristicNominalKey"><xs:selector xpath="t:Characteristics/t:CharacteristicNominals/t:*"/><xs:field xpath="@id"/></xs:key>
            <xs:keyref name="CharacteristicNominalRef" refer="CharacteristicNominalKey"><xs:selector xpath=".//t:CharacteristicNominalId"/><xs:field xpath="."/></xs:keyref>
            <xs:key name="CharacteristicItemKey"><xs:selector xpath="t:Characteristics/t:CharacteristicItems/t:*"/><xs:field xpath="@id"/></xs:key>
            <xs:keyref name="CharacteristicItemRef" refer="CharacteristicItemKey"><xs:selector xpath=".//t:CharacteristicItemId"/><xs:field xpath="."/></xs:keyref>
            <xs:key name="MeasurementKey"><xs:selector xpath=".//t:PointFeatureMeasurement"/><xs:field xpath="@id"/></xs:key>
            <xs:keyref name="MeasurementRef" refer="MeasurementKey"><xs:selector xpath=".//t:FeatureMeasurementIds/t:Id"/><xs:field xpath="."/></xs:keyref>
          </xs:element>
        </xs:schema>
        """;

    private static readonly Lazy<XmlSchemaSet> Schemas = new(() =>
    {
        var set = new XmlSchemaSet();
        set.Add(null, XmlReader.Create(new StringReader(Text)));
        return set;
    });

    /// <summary>What is wrong with a document; empty if it is valid.</summary>
    public static IReadOnlyList<string> Check(string document)
    {
        var problems = new List<string>();
        var xml = XDocument.Parse(document);
        xml.Validate(Schemas.Value, (_, e) => problems.Add(e.Message));

        // What a schema cannot say: the counts of lists, and the largest identifier.
        problems.AddRange(xml.Descendants()
            .Where(e => e.Attribute("n") is { } n && (int)n != e.Elements().Count())
            .Select(e => $"{e.Name.LocalName} has another number of elements than n."));
        if (xml.Descendants().Max(e => (int?)e.Attribute("id")) != (int?)xml.Root!.Attribute("idMax"))
        {
            problems.Add("idMax is not the largest identifier.");
        }

        return problems;
    }
}

// Converts ontologies with the OWL API into the five syntaxes that heed reads:
// java -cp '/usr/share/java/*' Convert.java FOLDER FILE... writes FOLDER/<name of FILE>.<owl|ttl|owx|ofn|omn>.
// Imports are not loaded; a file that the OWL API refuses is named on standard error and ends the run with 1.

import java.io.File;
import java.io.FileOutputStream;
import java.io.OutputStream;
import java.util.LinkedHashMap;
import java.util.Map;
import org.semanticweb.owlapi.apibinding.OWLManager;
import org.semanticweb.owlapi.formats.FunctionalSyntaxDocumentFormat;
import org.semanticweb.owlapi.formats.ManchesterSyntaxDocumentFormat;
import org.semanticweb.owlapi.formats.OWLXMLDocumentFormat;
import org.semanticweb.owlapi.formats.RDFXMLDocumentFormat;
import org.semanticweb.owlapi.formats.TurtleDocumentFormat;
import org.semanticweb.owlapi.io.FileDocumentSource;
import org.semanticweb.owlapi.model.MissingImportHandlingStrategy;
import org.semanticweb.owlapi.model.OWLDocumentFormat;
import org.semanticweb.owlapi.model.OWLOntology;
import org.semanticweb.owlapi.model.OWLOntologyLoaderConfiguration;
import org.semanticweb.owlapi.model.OWLOntologyManager;

public class Convert {
  private static Map<String, OWLDocumentFormat> formats() {
    Map<String, OWLDocumentFormat> formats = new LinkedHashMap<>();
    formats.put("owl", new RDFXMLDocumentFormat());
    formats.put("ttl", new TurtleDocumentFormat());
    formats.put("owx", new OWLXMLDocumentFormat());
    formats.put("ofn", new FunctionalSyntaxDocumentFormat());
    formats.put("omn", new ManchesterSyntaxDocumentFormat());
    return formats;
  }

  private static void convert(File file, File folder) throws Exception {
    OWLOntologyManager manager = OWLManager.createOWLOntologyManager();
    OWLOntologyLoaderConfiguration configuration = new OWLOntologyLoaderConfiguration()
        .setMissingImportHandlingStrategy(MissingImportHandlingStrategy.SILENT)
        .setFollowRedirects(false);
    OWLOntology ontology = manager.loadOntologyFromOntologyDocument(new FileDocumentSource(file), configuration);
    for (Map.Entry<String, OWLDocumentFormat> entry : formats().entrySet()) {
      File target = new File(folder, file.getName() + "." + entry.getKey());
      try (OutputStream out = new FileOutputStream(target)) {
        manager.saveOntology(ontology, entry.getValue(), out);
      }
    }
  }

  public static void main(String[] arguments) {
    boolean failed = false;
    for (int i = 1; i < arguments.length; ++i) {
      try {
        convert(new File(arguments[i]), new File(arguments[0]));
      } catch (Exception | LinkageError error) {
        System.err.println(arguments[i] + ": " + error);
        failed = true;
      }
    }
    System.exit(failed ? 1 : 0);
  }
}
